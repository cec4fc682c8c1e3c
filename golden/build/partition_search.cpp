// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/partition_search.h"

#include <algorithm>
#include <cmath>

#include "golden/build/centroid_sweep.h"
#include "golden/build/grid_oracle.h"

namespace cbvh::golden {
namespace {

class Shortlist {
 public:
  explicit Shortlist(std::size_t most) : most_(most) {}

  /// What a partition has to cost less than.
  double bound() const { return all_.size() < most_ ? std::numeric_limits<double>::infinity() : all_.back().cost; }

  void offer(const Partition& partition) {
    if (!(partition.cost < bound())) return;
    if (all_.size() == most_) all_.pop_back();
    const auto behind = std::upper_bound(all_.begin(), all_.end(), partition,
                                         [](const Partition& a, const Partition& b) { return a.cost < b.cost; });
    all_.insert(behind, partition);
  }

  std::vector<Partition> take() && { return std::move(all_); }

 private:
  std::size_t most_;
  std::vector<Partition> all_;
};

void search_centroids(std::span<const Piece> pieces, const OverlapPenalty& penalty, Shortlist& found) {
  for_each_centroid(pieces, [&](const Split& split, const WideBox& left, const WideBox& right) {
    if (!(split.cost < found.bound())) return;
    Partition partition;
    partition.penalty = penalty.factor(narrowed(left), narrowed(right));
    partition.cost = split.cost * partition.penalty;
    partition.objects = split;
    found.offer(partition);
  });
}

void search_planes(std::span<const Piece> pieces, const Box& node, Shortlist& found) {
  for_each_plane(pieces, node, false, [&](const PlaneSplit& plane) {
    if (!(plane.cost < found.bound())) return;
    Partition partition;
    partition.kind = Partition::Kind::plane;
    partition.cost = plane.cost;
    partition.plane = plane;
    found.offer(partition);
  });
}

/// Whether an axis alone shows that these intervals leave a piece out: it is in neither, and they may not or do not
/// hold it together.
bool leaves_out(const Piece& piece, int axis, const GridOracle::Intervals& intervals, bool may_split) {
  const float lower = piece.box.lower[axis];
  const float upper = piece.box.upper[axis];
  const auto& [first, second] = intervals;
  if ((first[0] <= lower && upper <= first[1]) || (second[0] <= lower && upper <= second[1])) return false;
  return !may_split || first[1] < second[0] || second[1] < first[0];
}

void search_grid(std::span<const Piece> pieces, const Box& node, const Mesh& mesh, const SearchRules& rules,
                 const OverlapPenalty& penalty, Shortlist& found) {
  const auto count = static_cast<double>(pieces.size());
  GridOracle oracle(node, std::sqrt(rules.resolution * count));
  oracle.keep([&](int axis, const GridOracle::Intervals& intervals) {
    return std::none_of(pieces.begin(), pieces.end(),
                        [&](const Piece& piece) { return leaves_out(piece, axis, intervals, rules.may_split); });
  });
  CountTree tree(pieces, mesh);
  oracle.for_each([&](const std::array<Box, 2>& boxes) {
    // What can be seen without counting: every piece is in the smaller box, and the factor.
    constexpr double kRoundedDown = 1 - 0x1p-50;
    const double left = half_area(boxes[0]);
    const double right = half_area(boxes[1]);
    const double least = std::min(left, right) * count;
    if (least * kRoundedDown >= found.bound()) return;
    Partition partition;
    partition.kind = Partition::Kind::boxes;
    partition.penalty = penalty.factor(boxes[0], boxes[1]);
    if (least * partition.penalty * kRoundedDown >= found.bound()) return;
    partition.boxes.box = boxes;
    if (!tree.count(partition.boxes, rules.may_split, found.bound() / (partition.penalty * kRoundedDown))) return;
    if (partition.left() == 0 || partition.right() == 0) return;
    partition.cost = (left * partition.left() + right * partition.right()) * partition.penalty;
    found.offer(partition);
  });
}

}  // namespace

std::vector<Partition> cheapest_partitions(std::span<const Piece> pieces, const Box& node, const Mesh& mesh,
                                           const SearchRules& rules) {
  const OverlapPenalty penalty(rules.overlap, node);
  Shortlist found(rules.most);
  const bool has_area = half_area(node) > 0;
  if (rules.centroids) search_centroids(pieces, penalty, found);
  if (rules.planes && has_area) search_planes(pieces, node, found);
  if (rules.grid && has_area) search_grid(pieces, node, mesh, rules, penalty, found);
  return std::move(found).take();
}

}  // namespace cbvh::golden
