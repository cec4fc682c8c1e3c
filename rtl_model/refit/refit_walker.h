// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/compress/context_stack.h"
#include "rtl_model/datapath/box_union.h"
#include "rtl_model/datapath/refit_payloads.h"
#include "rtl_model/kernel/fifo.h"

namespace cbvh::rtl {

/// Walks an existing tree in its emission order, bottom up, and gives every pair the boxes of the primitives that are
/// below it now. Nodes that are closed wait for their parent on a stack, leaves in the order of the ID array among
/// them: a pair takes its two children from the top, and they must be the two it points to. So what is given is a tree,
/// and its leaves are all there is in the ID array; a tree that is not like that is refused, with the first fault,
/// whereas the walk goes on to the end of its inputs: to the stream compressor it then sends one pair that is refused
/// as well. For each tree the registers are given first. A clock brings a primitive to the leaf that is being put
/// together, and puts a leaf on the stack or closes a pair (of which a right leaf comes along in the same clock): 1.5
/// clocks a pair. Memory: 32 nodes of 220 bits, two read and one written a clock. Wald's refit, paper section 5.2.
template <class Bits>
class RefitWalker {
 public:
  static constexpr std::size_t kMarks = 16;  ///< primitives in flight between the two streams that meet here

  RefitWalker(Channel<SceneRegisters>& starts, Channel<TopologyPair>& topology, Channel<PrimitiveBox>& boxes,
              Channel<LeafMark>& marks, Channel<StreamJob>& jobs, Channel<WalkReport>& reports)
      : starts_(starts), topology_(topology), boxes_(boxes), marks_(marks), jobs_(jobs), reports_(reports) {}

  void tick() {
    if (marks_.can_pop() && waiting_marks_.free() > 0) waiting_marks_.push() = marks_.pop();
    if (!running_) {
      if (!starts_.can_pop()) return;
      registers_ = starts_.pop();
      running_ = true;
      return;
    }
    if (topology_done_ && ids_done_ && !leaf_.ready) {
      finish();
      return;
    }
    if (report_.fault != RefitFaultBits()) {
      drain();
    } else if (topology_.can_pop()) {
      walk(topology_.front());
    }
    if (!leaf_.ready && !ids_done_) add_primitive();
  }
  void commit(CommitKey) {}

 private:
  struct Node {
    FloatBox box;
    bool leaf = false;
    std::uint64_t pointer = 0;  ///< what its parent must point to
  };
  /// The next leaf of the ID array.
  struct Leaf {
    Node node;
    bool begun = false;
    bool ready = false;  ///< complete
    RefitFault fault = RefitFault::none;
    std::uint64_t place = 0;  ///< of the fault
  };

  void add_primitive() {
    if (waiting_marks_.empty() || !boxes_.can_pop()) return;
    const LeafMark mark = waiting_marks_.front();
    const PrimitiveBox& next = boxes_.pop();
    waiting_marks_.pop();
    if (!leaf_.begun) leaf_.node = {next.box, true, next_id_};
    if (leaf_.begun) leaf_.node.box = unite_boxes<Bits>(leaf_.node.box, next.box);
    leaf_.begun = true;
    if (leaf_.fault == RefitFault::none) {
      leaf_.fault = fault_of(mark, next);
      leaf_.place = next_id_;
    }
    leaf_.ready = bool(mark.last_of_leaf) || bool(mark.last);
    ids_done_ = bool(mark.last);
    ++next_id_;
  }
  static RefitFault fault_of(const LeafMark& mark, const PrimitiveBox& next) {
    if (!mark.in_range) return RefitFault::id_out_of_range;
    if (next.status != StatusBits()) return RefitFault::primitive_not_finite;
    return mark.last && !mark.last_of_leaf ? RefitFault::ids_missing : RefitFault::none;
  }

  void walk(const TopologyPair& pair) {
    const bool left_leaf = bool(pair.leaf[0]), right_leaf = bool(pair.leaf[1]);
    if (left_leaf || right_leaf) {
      const std::uint64_t wanted = pair.pointer[right_leaf ? 1 : 0].value();
      if (wanted >= leaf_begin()) {  // leaves up to this one come before the pair
        if (!leaf_.ready) {
          if (ids_done_) refuse(RefitFault::ids_missing, pair_index_);
          return;
        }
        if (leaf_.fault != RefitFault::none) return refuse(leaf_.fault, leaf_.place);
        if (!right_leaf || wanted != leaf_.node.pointer) return push_leaf();
        close(pair, leaf_.node, 0);
        return;
      }
    }
    if (stack_.depth() < 1) return refuse(RefitFault::not_post_order, pair_index_);
    close(pair, stack_.top(), 1);
  }
  std::uint64_t leaf_begin() const { return leaf_.begun ? leaf_.node.pointer : next_id_; }

  void push_leaf() {
    if (stack_.depth() == stack_.capacity()) return refuse(RefitFault::too_deep, pair_index_);
    stack_.push() = leaf_.node;
    leaf_ = {};
  }

  /// The left child lies `below` the top.
  void close(const TopologyPair& pair, const Node& right, std::size_t below) {
    if (stack_.depth() <= below || !is_child(pair, 0, stack_.top(below)) || !is_child(pair, 1, right)) {
      return refuse(RefitFault::not_post_order, pair_index_);
    }
    const bool right_is_last_leaf = below == 0 && ids_done_;
    const bool all_ids_used = right_is_last_leaf || (below == 1 && ids_done_ && !leaf_.ready);
    if (pair.last && (!all_ids_used || stack_.depth() != below + 1)) {
      return refuse(RefitFault::leftovers, pair_index_);
    }
    if (!jobs_.can_push()) return;
    const Node& left = stack_.top(below);
    jobs_.push({{{left.box, right.box}, pair.leaf, pair.pointer}, pair.last, registers_});
    const Node closed{unite_boxes<Bits>(left.box, right.box), false, pair_index_};
    if (below == 0) leaf_ = {};
    stack_.drop(below);
    stack_.top() = closed;
    topology_done_ = bool(pair.last);
    ++pair_index_;
    topology_.pop();
  }
  static bool is_child(const TopologyPair& pair, std::size_t child, const Node& node) {
    return bool(pair.leaf[child]) == node.leaf && pair.pointer[child].value() == node.pointer;
  }

  void refuse(RefitFault fault, std::uint64_t place) {
    if (!taken<Bits>(Corner::walker_refuses, true) || !jobs_.can_push()) return;
    StreamJob refused;
    refused.root = UInt<1>(1);
    refused.registers = registers_;
    refused.pair.leaf = {UInt<1>(1), UInt<1>(1)};
    refused.pair.box[0].lower[0] = Float32::of_raw(0x7FC00000);  // not a number
    jobs_.push(refused);
    report_ = {RefitFaultBits(static_cast<std::uint64_t>(fault)), Pointer::of_raw(place)};
  }
  void drain() {
    leaf_ = {};
    if (!topology_done_ && topology_.can_pop()) topology_done_ = bool(topology_.pop().last);
  }

  void finish() {
    if (!reports_.can_push()) return;
    reports_.push(report_);
    report_ = {};
    stack_.clear();
    next_id_ = pair_index_ = 0;
    running_ = topology_done_ = ids_done_ = false;
  }

  Channel<SceneRegisters>& starts_;
  Channel<TopologyPair>& topology_;
  Channel<PrimitiveBox>& boxes_;
  Channel<LeafMark>& marks_;
  Channel<StreamJob>& jobs_;
  Channel<WalkReport>& reports_;
  Fifo<LeafMark> waiting_marks_{kMarks};
  StackStorage<Node, kContextStackDepth> stack_;
  SceneRegisters registers_;
  Leaf leaf_;
  WalkReport report_;
  std::uint64_t next_id_ = 0;  ///< index of the next primitive in the ID array
  std::uint64_t pair_index_ = 0;
  bool running_ = false;
  bool topology_done_ = false;
  bool ids_done_ = false;
};

}  // namespace cbvh::rtl
