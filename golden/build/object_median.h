// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cbvh::golden {

/// A place in the order of keys; equal keys keep their order.
struct Rank {
  float key;
  std::uint32_t index;
  friend bool operator<(const Rank& a, const Rank& b) { return a.key < b.key || (a.key == b.key && a.index < b.index); }
};

/// The object median of `count` keys, at least 2: exactly count / 2 of the Rank{key_of(i), i} come before it. Where
/// nothing tells the objects apart it splits them by their order.
template <class KeyOf>
Rank object_median(std::uint32_t count, const KeyOf& key_of) {
  std::vector<Rank> ranks(count);
  for (std::uint32_t i = 0; i < count; ++i) ranks[i] = {key_of(i), i};
  const auto middle = ranks.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(ranks.begin(), middle, ranks.end());
  return *middle;
}

}  // namespace cbvh::golden
