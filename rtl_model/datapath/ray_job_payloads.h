// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/ray_payloads.h"
#include "rtl_model/memory/line_port.h"

/// What goes into the traversal unit and comes out of it.
namespace cbvh::rtl {

constexpr int kRayNumberBits = 32;
constexpr int kRaySlotBits = 6;  ///< at most 64 rays in flight
constexpr int kRayCountBits = 24;

using RaySlot = UInt<kRaySlotBits>;

/// A tree in memory, by configuration wires. Its arrays begin at lines.
template <int N>
struct RayTree {
  LineAddress pairs;
  LineAddress ids;
  UInt<1> leaf;  ///< the tree is a single leaf, whose entries begin at `root`
  Pointer root;  ///< else the root's pair
  FloatBox box;  ///< the root's cells, decoded; +-infinity stands for +-2^128
  std::array<GridAxis<N>, 3> grid;
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pairs", &RayTree::pairs, "ids", &RayTree::ids, "leaf", &RayTree::leaf, "root", &RayTree::root,
                      "box", &RayTree::box, "grid", &RayTree::grid, "registers", &RayTree::registers);
  }
  bool operator==(const RayTree&) const = default;
};

struct RayJob {
  UInt<kRayNumberBits> number;  ///< comes back with whatever is said of the ray
  std::array<Float32, 3> origin;
  std::array<Float32, 3> direction;
  Float32 t_min;
  Float32 t_max;
  static constexpr auto fields() {
    return field_list("number", &RayJob::number, "origin", &RayJob::origin, "direction", &RayJob::direction, "t_min",
                      &RayJob::t_min, "t_max", &RayJob::t_max);
  }
  bool operator==(const RayJob&) const = default;
};

/// A primitive of a leaf that a ray reached, to be intersected outside.
struct RayCandidate {
  UInt<kRayNumberBits> number;
  RaySlot slot;
  Pointer entry_index;  ///< of the primitive-ID array
  Pointer primitive;
  UInt<1> last_of_leaf;  ///< a LeafReply is awaited
  Float32 entry;         ///< where the ray enters the leaf's box
  static constexpr auto fields() {
    return field_list("number", &RayCandidate::number, "slot", &RayCandidate::slot, "entry_index",
                      &RayCandidate::entry_index, "primitive", &RayCandidate::primitive, "last_of_leaf",
                      &RayCandidate::last_of_leaf, "entry", &RayCandidate::entry);
  }
  bool operator==(const RayCandidate&) const = default;
};

/// What the primitives of a leaf did to a ray.
struct LeafReply {
  RaySlot slot;
  Float32 t;     ///< of the nearest hit, or infinite; shortens the ray
  UInt<1> stop;  ///< the ray is done (any hit is enough)
  static constexpr auto fields() {
    return field_list("slot", &LeafReply::slot, "t", &LeafReply::t, "stop", &LeafReply::stop);
  }
  bool operator==(const LeafReply&) const = default;
};

/// The end of a ray.
struct RayReport {
  UInt<kRayNumberBits> number;
  StatusBits status;          ///< of the ray, of a pair it met, or overflow of its stack
  Pointer place;              ///< the pair it ended at, if the status is not ok
  UInt<kRayCountBits> pairs;  ///< visited
  UInt<kRayCountBits> leaves;
  UInt<kRayCountBits> lines;  ///< read for pairs
  Float32 t_max;              ///< as it is at the end
  static constexpr auto fields() {
    return field_list("number", &RayReport::number, "status", &RayReport::status, "place", &RayReport::place, "pairs",
                      &RayReport::pairs, "leaves", &RayReport::leaves, "lines", &RayReport::lines, "t_max",
                      &RayReport::t_max);
  }
  bool operator==(const RayReport&) const = default;
};

}  // namespace cbvh::rtl
