// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/refit.h"

#include <limits>
#include <optional>

#include "golden/build/float_tree.h"
#include "vectors/convert.h"

namespace cbvh::vectors {
namespace {

using rtl::RefitFault;

constexpr std::size_t kMostOpenNodes = 32;

struct Fault {
  RefitFault reason;
  std::size_t place;
};
struct Node {
  golden::Box box;
  bool leaf;
  std::size_t pointer;
};
struct Leaf {
  Node node;
  std::optional<Fault> fault;
};

std::vector<Leaf> leaves_of(std::span<const WalkPrimitive> primitives) {
  std::vector<Leaf> leaves;
  bool begins = true;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const WalkPrimitive& primitive = primitives[i];
    if (begins) leaves.push_back({{primitive.box, true, i}, {}});
    Leaf& leaf = leaves.back();
    leaf.node.box = golden::unite(leaf.node.box, primitive.box);
    if (!leaf.fault && !primitive.in_range) leaf.fault = Fault{RefitFault::id_out_of_range, i};
    if (!leaf.fault && !primitive.finite) leaf.fault = Fault{RefitFault::primitive_not_finite, i};
    begins = primitive.last_of_leaf;
  }
  if (!begins && !leaves.back().fault) leaves.back().fault = Fault{RefitFault::ids_missing, primitives.size() - 1};
  return leaves;
}

/// Nodes become children in the order in which they are closed; leaves where their numbers put them.
class Walk {
 public:
  explicit Walk(std::span<const WalkPrimitive> primitives)
      : leaves_(leaves_of(primitives)), entries_(primitives.size()) {}

  /// The pair's children with their boxes, or what is wrong.
  std::optional<Fault> close(const rtl::TopologyPair& pair, std::size_t index, std::array<Node, 2>& children) {
    std::optional<Node> right;
    if (pair.leaf[0] || pair.leaf[1]) {
      const std::size_t last_leaf = pair.pointer[pair.leaf[1] ? 1 : 0].raw();
      while (!right && (next_ < leaves_.size() ? leaves_[next_].node.pointer : entries_) <= last_leaf) {
        if (next_ == leaves_.size()) return Fault{RefitFault::ids_missing, index};
        const Leaf& leaf = leaves_[next_];
        if (leaf.fault) return leaf.fault;
        const bool is_right = pair.leaf[1] && leaf.node.pointer == last_leaf;
        if (!is_right && open_.size() == kMostOpenNodes) return Fault{RefitFault::too_deep, index};
        ++next_;
        if (is_right) {
          right = leaf.node;
        } else {
          open_.push_back(leaf.node);
        }
      }
    }
    if (right) open_.push_back(*right);
    if (open_.size() < 2) return Fault{RefitFault::not_post_order, index};
    for (const std::size_t c : {std::size_t{1}, std::size_t{0}}) {
      children[c] = open_.back();
      open_.pop_back();
      if (children[c].leaf != bool(pair.leaf[c]) || children[c].pointer != pair.pointer[c].raw()) {
        return Fault{RefitFault::not_post_order, index};
      }
    }
    if (pair.last && !(open_.empty() && next_ == leaves_.size())) return Fault{RefitFault::leftovers, index};
    open_.push_back({golden::unite(children[0].box, children[1].box), false, index});
    return {};
  }

 private:
  std::vector<Leaf> leaves_;
  std::vector<Node> open_;
  std::size_t entries_;
  std::size_t next_ = 0;  ///< the next leaf
};

}  // namespace

WalkAnswer walk_tree(std::span<const rtl::TopologyPair> pairs, std::span<const WalkPrimitive> primitives,
                     const rtl::SceneRegisters& registers) {
  WalkAnswer answer;
  Walk walk(primitives);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::array<Node, 2> children{};
    rtl::StreamJob job;
    job.registers = registers;
    if (const auto fault = walk.close(pairs[i], i, children)) {
      job.root = rtl::UInt<1>(1);
      job.pair.leaf = {rtl::UInt<1>(1), rtl::UInt<1>(1)};
      job.pair.box[0].lower[0] = rtl::Float32::of(std::numeric_limits<float>::quiet_NaN());
      answer.report = {rtl::RefitFaultBits(static_cast<std::uint64_t>(fault->reason)),
                       rtl::Pointer::of_raw(fault->place)};
      answer.jobs.push_back(job);
      return answer;
    }
    job.root = pairs[i].last;
    job.pair.leaf = pairs[i].leaf;
    job.pair.pointer = pairs[i].pointer;
    for (std::size_t c = 0; c < 2; ++c) job.pair.box[c] = float_box(children[c].box);
    answer.jobs.push_back(job);
  }
  return answer;
}

}  // namespace cbvh::vectors
