// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/traversal.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "golden/build/float_tree.h"

namespace cbvh::vectors {

using rtl::Status;

namespace {

struct Waiting {
  bool leaf;
  std::uint32_t pointer;
  float entry;
  PlainReachedNode node;
};

/// One ray on its way.
class Traveller {
 public:
  Traveller(const PlainRay& ray, const PlainRayTree& tree, int bits, TraversedRay& result)
      : ray_(ray), tree_(tree), bits_(bits), result_(result) {
    result_.t_max = ray.t_max;
  }

  /// Whether the ray reaches the root.
  bool set_up() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lower, upper] = tree_.box[axis];
      const Status found = setup_status(ray_.origin[axis], ray_.direction[axis], lower, upper);
      if (found != Status::ok && (result_.status == Status::ok || found < result_.status)) result_.status = found;
    }
    if (std::isnan(ray_.t_min) || std::isnan(ray_.t_max)) result_.status = Status::not_finite;
    if (result_.status != Status::ok) return false;
    Waiting root{tree_.leaf, tree_.root, 0, {tree_.grid, {}}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lower, upper] = tree_.box[axis];
      const AxisSetup setup = set_up_axis(ray_.origin[axis], ray_.direction[axis], lower, upper);
      axes_[axis] = setup.ray;
      root.node.planes[axis] = setup.planes;
    }
    const BoxInterval inside = box_interval(root.node.planes, axes_, ray_.t_min, ray_.t_max);
    root.entry = inside.entry;
    if (inside.hit) waiting_.push_back(root);
    return inside.hit;
  }

  void run(const std::function<void(const PlainCandidate&)>& meet, const std::function<PlainReply()>& reply) {
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (next.entry > result_.t_max) continue;
      if (!next.leaf) {
        if (!open(next)) return;
        continue;
      }
      visit_leaf(next, meet);
      const PlainReply answer = reply();
      result_.t_max = std::min(result_.t_max, answer.t);
      if (answer.stop) return;
    }
  }

 private:
  bool open(const Waiting& node) {
    constexpr std::uint32_t kPairsInLine = 4;
    ++result_.pairs;
    if (std::optional<std::uint32_t> line = node.pointer / kPairsInLine; line != line_) {
      line_ = line;
      ++result_.lines;
    }
    PlainPairTest test{tree_.pair(node.pointer), node.node, axes_, ray_.t_min, result_.t_max, tree_.registers};
    const PairTestAnswer answer = test_pair(test, bits_);
    const bool first = answer.child[0].inside.hit;
    const bool second = answer.child[1].inside.hit;
    result_.status = answer.status;
    if (answer.status == Status::ok && first && second && waiting_.size() == kMostWaiting) {
      result_.status = Status::overflow;
    }
    if (result_.status != Status::ok) {
      result_.place = node.pointer;
      return false;
    }
    const auto wait = [&](std::size_t c) {
      if (!answer.child[c].inside.hit) return;
      waiting_.push_back(
          {test.pair.child[c].leaf, test.pair.child[c].pointer, answer.child[c].inside.entry, answer.child[c].node});
    };
    wait(answer.second_first ? 0 : 1);
    wait(answer.second_first ? 1 : 0);
    return true;
  }

  void visit_leaf(const Waiting& leaf, const std::function<void(const PlainCandidate&)>& meet) {
    ++result_.leaves;
    for (std::uint32_t index = leaf.pointer;; ++index) {
      const std::uint32_t entry = tree_.entry(index);
      const bool last = (entry & golden::kLastOfLeaf) != 0;
      meet({index, entry % static_cast<std::uint32_t>(golden::kMaxCount), last, leaf.entry});
      if (last) return;
    }
  }

  const PlainRay& ray_;
  const PlainRayTree& tree_;
  int bits_;
  TraversedRay& result_;
  std::array<PlainRayAxis, 3> axes_{};
  std::vector<Waiting> waiting_;
  std::optional<std::uint32_t> line_;
};

}  // namespace

TraversedRay traverse(const PlainRay& ray, const PlainRayTree& tree, int bits,
                      const std::function<void(const PlainCandidate&)>& meet,
                      const std::function<PlainReply()>& reply) {
  TraversedRay result;
  Traveller traveller(ray, tree, bits, result);
  if (traveller.set_up()) traveller.run(meet, reply);
  return result;
}

}  // namespace cbvh::vectors
