// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/payloads.h"
#include "rtl_model/memory/line_port.h"

/// What travels between the modules that make a hierarchy out of triangles. Every stream marks its last item.
namespace cbvh::rtl {

constexpr int kMortonBits = 30;
using PrefixLength = UInt<bits_for(kMortonBits)>;  ///< leading bits that two codes share

/// Ten 32-bit words in memory: three vertices of x y z, then the primitive's number. Paper section 5.
struct Primitive {
  std::array<std::array<Float32, 3>, 3> vertex;
  Pointer id;
  UInt<1> last;
  static constexpr auto fields() {
    return field_list("vertex", &Primitive::vertex, "id", &Primitive::id, "last", &Primitive::last);
  }
  bool operator==(const Primitive&) const = default;
};
constexpr std::uint64_t kWordsPerPrimitive = 10;

/// The box of a primitive; no zero in it is negative.
struct PrimitiveBox {
  FloatBox box;
  Pointer id;
  UInt<1> last;
  StatusBits status;  ///< ok or not_finite; otherwise the box is zero
  static constexpr auto fields() {
    return field_list("box", &PrimitiveBox::box, "id", &PrimitiveBox::id, "last", &PrimitiveBox::last, "status",
                      &PrimitiveBox::status);
  }
  bool operator==(const PrimitiveBox&) const = default;
};

/// Configuration registers, constant over a scene: the box around all boxes of its primitives.
struct SceneBox {
  FloatBox scene;
  static constexpr auto fields() { return field_list("scene", &SceneBox::scene); }
  bool operator==(const SceneBox&) const = default;
};

/// A primitive with its place on the Morton curve: eight words in memory, box lower x y z, upper x y z, code, id.
struct SortRecord {
  FloatBox box;
  UInt<kMortonBits> code;
  Pointer id;
  static constexpr auto fields() {
    return field_list("box", &SortRecord::box, "code", &SortRecord::code, "id", &SortRecord::id);
  }
  bool operator==(const SortRecord&) const = default;
};
constexpr std::uint64_t kWordsPerRecord = 8;
constexpr std::uint64_t kRecordsPerLine = 2;

/// A record on its way into or out of the sorter.
struct SortItem {
  SortRecord record;
  UInt<1> last_of_run;  ///< the last of a sorted run; before the sorter zero
  UInt<1> last;         ///< the last of the scene
  static constexpr auto fields() {
    return field_list("record", &SortItem::record, "last_of_run", &SortItem::last_of_run, "last", &SortItem::last);
  }
  bool operator==(const SortItem&) const = default;
};

/// A pass over the sorted runs: where they are to be written.
struct RunArea {
  LineAddress first_line;
  LineAddress padding;  ///< unused lines between two runs: spreads runs that are read together over the memory's banks
  static constexpr auto fields() {
    return field_list("first_line", &RunArea::first_line, "padding", &RunArea::padding);
  }
  bool operator==(const RunArea&) const = default;
};

/// Where a sorted run lies: it begins with a line.
struct RunDescriptor {
  LineAddress first_line;
  UInt<kPointerBits + 1> records;
  UInt<1> last;  ///< the last run of this pass
  static constexpr auto fields() {
    return field_list("first_line", &RunDescriptor::first_line, "records", &RunDescriptor::records, "last",
                      &RunDescriptor::last);
  }
  bool operator==(const RunDescriptor&) const = default;
};

/// An entry of the primitive-ID array, a word in memory with `last_of_leaf` as bit 31.
struct IdEntry {
  Pointer id;
  UInt<1> last_of_leaf;
  UInt<1> last;
  static constexpr auto fields() {
    return field_list("id", &IdEntry::id, "last_of_leaf", &IdEntry::last_of_leaf, "last", &IdEntry::last);
  }
  bool operator==(const IdEntry&) const = default;
};

/// A writer has finished: everything is in memory, and seen by every later read.
struct WriteReport {
  UInt<kPointerBits + 1> items;  ///< records, entries or pairs written
  UInt<32> lines;                ///< 64-byte writes made
  static constexpr auto fields() { return field_list("items", &WriteReport::items, "lines", &WriteReport::lines); }
  bool operator==(const WriteReport&) const = default;
};

/// A hierarchy has been emitted.
struct EmitReport {
  UInt<kPointerBits + 1> pairs;
  UInt<kPointerBits + 1> leaves;
  UInt<kPointerBits + 1> primitives;
  FloatBox root;
  UInt<5> depth;  ///< the most subtrees that waited for their right sibling at a time, 0..30
  static constexpr auto fields() {
    return field_list("pairs", &EmitReport::pairs, "leaves", &EmitReport::leaves, "primitives", &EmitReport::primitives,
                      "root", &EmitReport::root, "depth", &EmitReport::depth);
  }
  bool operator==(const EmitReport&) const = default;
};

}  // namespace cbvh::rtl
