// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/lbvh_payloads.h"

/// What travels between the modules that work on a tree which is there already.
namespace cbvh::rtl {

using ItemCount = UInt<kPointerBits + 1>;

/// An array in memory, from the beginning of a line on. It has at least one item.
struct ReadCommand {
  LineAddress first_line;
  ItemCount items;
  static constexpr auto fields() {
    return field_list("first_line", &ReadCommand::first_line, "items", &ReadCommand::items);
  }
  bool operator==(const ReadCommand&) const = default;
};

/// What a refit keeps of a packed node pair.
struct TopologyPair {
  std::array<UInt<1>, 2> leaf;
  std::array<Pointer, 2> pointer;
  UInt<1> last;
  static constexpr auto fields() {
    return field_list("leaf", &TopologyPair::leaf, "pointer", &TopologyPair::pointer, "last", &TopologyPair::last);
  }
  bool operator==(const TopologyPair&) const = default;
};

/// Goes beside a primitive that was fetched by its number.
struct LeafMark {
  UInt<1> last_of_leaf;
  UInt<1> last;      ///< of the ID array
  UInt<1> in_range;  ///< there is such a primitive; if not, zeros stand for it
  static constexpr auto fields() {
    return field_list("last_of_leaf", &LeafMark::last_of_leaf, "last", &LeafMark::last, "in_range",
                      &LeafMark::in_range);
  }
  bool operator==(const LeafMark&) const = default;
};

/// Why a tree cannot be refitted around these primitives; the first met in emission order.
enum class RefitFault : std::uint8_t {
  none,
  not_post_order,   ///< a child is not the node that was closed or read just before
  too_deep,         ///< more open nodes than a 30-bit Morton code allows
  ids_missing,      ///< a leaf begins behind the ID array, or the array ends inside a leaf
  leftovers,        ///< the root is closed, but not everything is in it
  id_out_of_range,  ///< an ID without a primitive
  primitive_not_finite
};
using RefitFaultBits = UInt<3>;

/// The end of a walk over a tree.
struct WalkReport {
  RefitFaultBits fault;
  Pointer place;  ///< of a fault: the pair, and for the last two kinds the entry of the ID array
  static constexpr auto fields() { return field_list("fault", &WalkReport::fault, "place", &WalkReport::place); }
  bool operator==(const WalkReport&) const = default;
};

/// A tree to refit: it has at least one pair, that is, two leaves.
struct RefitCommand {
  ItemCount pairs;
  ItemCount primitives;  ///< in memory; the ID array has as many entries
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pairs", &RefitCommand::pairs, "primitives", &RefitCommand::primitives, "registers",
                      &RefitCommand::registers);
  }
  bool operator==(const RefitCommand&) const = default;
};

/// The end of a refit. After a fault the tree in memory is void, and `tree` has a status that is not ok.
struct RefitReport {
  StreamReport tree;
  WalkReport walk;
  static constexpr auto fields() { return field_list("tree", &RefitReport::tree, "walk", &RefitReport::walk); }
  bool operator==(const RefitReport&) const = default;
};

/// A float tree to compress top down: it has at least one pair.
struct TopDownCommand {
  ItemCount pairs;
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pairs", &TopDownCommand::pairs, "registers", &TopDownCommand::registers);
  }
  bool operator==(const TopDownCommand&) const = default;
};

}  // namespace cbvh::rtl
