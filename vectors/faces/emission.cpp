// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/emission.h"

#include <algorithm>
#include <cmath>

#include "golden/input_error.h"

namespace cbvh::vectors {
namespace {

float finite(rtl::Float32 wires) {
  if (!std::isfinite(wires.value())) throw golden::InputError("box", "want finite coordinates");
  return wires.value();
}

std::vector<golden::CodedBox> from_wires(std::span<const rtl::SortRecord> sorted) {
  std::vector<golden::CodedBox> items;
  for (const rtl::SortRecord& record : sorted) {
    golden::CodedBox& item = items.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      item.box.lower[axis] = finite(record.box.lower[static_cast<std::size_t>(axis)]);
      item.box.upper[axis] = finite(record.box.upper[static_cast<std::size_t>(axis)]);
    }
    item.code = static_cast<std::uint32_t>(record.code.value());
    item.id = static_cast<std::uint32_t>(record.id.value());
    if (items.size() > 1 && item.code < items[items.size() - 2].code) {
      throw golden::InputError("code", "the records are not sorted");
    }
  }
  return items;
}

}  // namespace

Emission emit(std::span<const rtl::SortRecord> sorted) {
  Emission emission{golden::build_hierarchy(from_wires(sorted)), std::vector<std::uint32_t>(sorted.size()), 0};
  const golden::FloatTree& tree = emission.tree;
  // The last record of a leaf, by the leaf's first entry.
  std::vector<std::uint32_t> last_of_leaf(sorted.size());
  for (std::uint32_t i = 0, first = 0; i < sorted.size(); ++i) {
    if ((tree.primitive_ids[i] & golden::kLastOfLeaf) == 0) continue;
    last_of_leaf[first] = i;
    first = i + 1;
  }
  std::vector<std::uint32_t> last_of_pair;
  for (const golden::FloatPair& pair : tree.pairs) {
    last_of_pair.push_back(pair.leaf[1] ? last_of_leaf[pair.pointer[1]] : last_of_pair[pair.pointer[1]]);
    ++emission.ends[last_of_pair.back()];
  }
  // While a subtree is being emitted, of each pair above it whose right child holds it the left child waits.
  std::vector<std::uint32_t> waiting(tree.pairs.size());
  for (std::size_t i = tree.pairs.size(); i-- > 0;) {
    for (std::uint32_t child = 0; child < 2; ++child) {
      if (!tree.pairs[i].leaf[child]) waiting[tree.pairs[i].pointer[child]] = waiting[i] + child;
      emission.depth = std::max(emission.depth, waiting[i] + child);
    }
  }
  return emission;
}

}  // namespace cbvh::vectors
