// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/centroid_sweep.h"

#include <algorithm>

namespace cbvh::golden {

std::vector<Rank> by_centroid(std::span<const Piece> pieces, int axis) {
  std::vector<Rank> order;
  order.reserve(pieces.size());
  for (const Piece& piece : pieces)
    order.push_back(
        {piece.box.lower[axis] * 0.5F + piece.box.upper[axis] * 0.5F, static_cast<std::uint32_t>(order.size())});
  std::sort(order.begin(), order.end());
  return order;
}

void for_each_centroid(std::span<const Piece> pieces,
                       const std::function<void(const Split&, const WideBox& left, const WideBox& right)>& visit) {
  const auto count = static_cast<std::uint32_t>(pieces.size());
  std::vector<WideBox> right(count);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<Rank> order = by_centroid(pieces, axis);
    WideBox box;
    for (std::uint32_t i = count - 1; i > 0; --i) {
      box.enclose(widened(pieces[order[i].index].box));
      right[i] = box;
    }
    box = {};
    for (std::uint32_t i = 1; i < count; ++i) {
      box.enclose(widened(pieces[order[i - 1].index].box));
      visit({half_area(box) * i + half_area(right[i]) * (count - i), axis, i, i}, box, right[i]);
    }
  }
}

Split best_centroid(std::span<const Piece> pieces) {
  Split best;
  for_each_centroid(pieces, [&](const Split& split, const WideBox&, const WideBox&) {
    if (split.cost < best.cost) best = split;
  });
  return best;
}

}  // namespace cbvh::golden
