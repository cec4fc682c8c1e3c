// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtl_model/datapath/intersect_pair.h"
#include "rtl_model/datapath/node_words.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/fifo.h"
#include "rtl_model/traverse/ray_slot.h"

namespace cbvh::rtl {

/// The channels of a ray scheduler.
template <int N>
struct RaySchedulerPorts {
  Channel<RayJob>& rays;
  Channel<RaySetupJob>& setups;
  Channel<RaySetupResult>& set_up;
  Channel<PairTestJob<N>>& tests;
  Channel<PairTestResult<N>>& tested;
  Channel<RayCandidate>& candidates;
  Channel<LeafReply>& replies;
  Channel<RayReport>& reports;
  LinePort pairs;
  LinePort ids;
};

/// Leads rays through a tree: the nearer child of a pair first, the other waits on the ray's stack, and is dropped when
/// the ray has become too short for it. Up to `slots` rays are on their way at once; each of them waits for one thing
/// at a time, in the queue of those that wait for it, and moves at most one queue a clock.
template <class Bits, int N>
class RayScheduler {
 public:
  RayScheduler(const RaySchedulerPorts<N>& ports, const RayTree<N>& tree, std::size_t slots)
      : ports_(ports),
        tree_(tree),
        rays_(slots),
        free_(slots),
        in_setup_(slots),
        to_fetch_(slots),
        in_fetch_(slots),
        to_test_(slots),
        in_test_(slots),
        to_pop_(slots),
        to_read_ids_(slots),
        in_id_read_(slots),
        to_emit_(slots),
        to_report_(slots) {
    for (std::size_t slot = 0; slot < slots; ++slot) free_.push() = slot;
  }

  /// Who takes from a queue comes before those who add to it: what a step hands on is there for the next a clock later.
  void tick() {
    take_ray();
    report();
    request_id_line();
    emit_candidate();
    take_id_line();
    send_test();
    const bool arrived = take_pair_line();
    fetch_pair(arrived);
    pop();
    take_tested();
    take_set_up();
    take_reply();
  }
  void commit(CommitKey) {}

 private:
  using Slots = Fifo<std::size_t>;
  using State = RaySlotState<N>;

  static std::size_t take(Slots& queue) {
    const std::size_t slot = queue.front();
    queue.pop();
    return slot;
  }
  static void count(UInt<kRayCountBits>& counter) { counter = UInt<kRayCountBits>::of_raw(counter.raw() + 1); }

  void take_ray() {
    if (free_.empty() || !ports_.rays.can_pop() || !ports_.setups.can_push()) return;
    const std::size_t slot = take(free_);
    const RayJob& job = ports_.rays.pop();
    State& ray = rays_[slot];
    ray.job = job;
    ray.t_max = job.t_max;
    ray.depth = 0;
    ray.has_line = false;
    ray.report = RayReport();
    ray.report.number = job.number;
    ports_.setups.push({job.origin, job.direction, tree_.box});
    in_setup_.push() = slot;
  }

  /// The root's box is tested here: it belongs to no pair.
  void take_set_up() {
    if (!ports_.set_up.can_pop()) return;
    const std::size_t slot = take(in_setup_);
    const RaySetupResult& setup = ports_.set_up.pop();
    State& ray = rays_[slot];
    ray.axes = setup.ray;
    const auto root = root_interval<Bits>(setup, ray.job.t_min, ray.job.t_max);
    ray.current = {tree_.leaf, tree_.root, lower_float(root.interval.entry), {tree_.grid, setup.planes}};
    ray.report.status = lower(root.status);
    if (bool(any(root.status)) || !root.interval.hit) {
      to_report_.push() = slot;
    } else {
      visit_current(slot);
    }
  }

  void visit_current(std::size_t slot) {
    State& ray = rays_[slot];
    if (ray.current.leaf) {
      count(ray.report.leaves);
      to_read_ids_.push() = slot;
    } else {
      count(ray.report.pairs);
      to_fetch_.push() = slot;
    }
  }

  /// A ray whose pair lies in its last line goes on at once, unless another one's line has just arrived.
  void fetch_pair(bool arrived) {
    if (to_fetch_.empty()) return;
    State& ray = rays_[to_fetch_.front()];
    const std::uint64_t line = tree_.pairs.raw() + ray.current.pointer.raw() / kPairsPerLine;
    if (ray.has_line && line == ray.line_number) {
      if (!arrived) to_test_.push() = take(to_fetch_);
      return;
    }
    if (!ports_.pairs.requests->can_push()) return;
    ports_.pairs.requests->push(read_of(line));
    ray.line_number = line;
    count(ray.report.lines);
    in_fetch_.push() = take(to_fetch_);
  }
  bool take_pair_line() {
    if (in_fetch_.empty() || !ports_.pairs.answers->can_pop()) return false;
    const std::size_t slot = take(in_fetch_);
    rays_[slot].line = ports_.pairs.answers->pop().words;
    rays_[slot].has_line = true;
    to_test_.push() = slot;
    return true;
  }
  static LineRequest read_of(std::uint64_t line) {
    LineRequest request;
    request.line = LineAddress::of_raw(line);
    return request;
  }

  void send_test() {
    if (to_test_.empty() || !ports_.tests.can_push()) return;
    const std::size_t slot = take(to_test_);
    const State& ray = rays_[slot];
    const std::size_t place = ray.current.pointer.raw() % kPairsPerLine;
    ports_.tests.push({unpack_pair<N>(words_of_slot(ray.line, place)), ray.current.node, ray.axes, ray.job.t_min,
                       ray.t_max, tree_.registers});
    in_test_.push() = slot;
  }

  void take_tested() {
    if (!ports_.tested.can_pop()) return;
    const std::size_t slot = take(in_test_);
    const PairTestResult<N>& tested = ports_.tested.pop();
    State& ray = rays_[slot];
    const bool both = bool(tested.child[0].hit & tested.child[1].hit);
    if (bool(any(tested.status))) {
      fail(slot, tested.status);
    } else if (both && taken<Bits>(Corner::ray_stack_overflow, ray.depth == kRayStackDepth)) {
      fail(slot, StatusBits(static_cast<std::uint64_t>(Status::overflow)));
    } else if (both) {
      const std::size_t nearer = tested.second_first.raw();
      ray.stack[ray.depth++] = waiting(tested.child[1 - nearer]);
      ray.current = waiting(tested.child[nearer]);
      visit_current(slot);
    } else if (bool(tested.child[0].hit | tested.child[1].hit)) {
      ray.current = waiting(tested.child[tested.child[1].hit.raw()]);
      visit_current(slot);
    } else {
      to_pop_.push() = slot;
    }
  }
  static WaitingNode<N> waiting(const TestedChild<N>& child) {
    return {child.leaf, child.pointer, child.entry, child.node};
  }
  void fail(std::size_t slot, StatusBits status) {
    State& ray = rays_[slot];
    ray.report.status = status;
    ray.report.place = ray.current.pointer;
    to_report_.push() = slot;
  }

  /// One waiting node a clock, dropped if the ray ends before it.
  void pop() {
    if (to_pop_.empty()) return;
    State& ray = rays_[to_pop_.front()];
    if (ray.depth == 0) {
      to_report_.push() = take(to_pop_);
      return;
    }
    ray.current = ray.stack[--ray.depth];
    const auto beyond = less(order_key<Bits>(lift<Bits>(ray.t_max)), order_key<Bits>(lift<Bits>(ray.current.entry)));
    if (bool(Bits::corner(Corner::ray_drops_waiting, beyond))) return;
    visit_current(take(to_pop_));
  }

  void request_id_line() {
    if (to_read_ids_.empty() || !ports_.ids.requests->can_push()) return;
    const std::size_t slot = take(to_read_ids_);
    ports_.ids.requests->push(read_of(tree_.ids.raw() + rays_[slot].current.pointer.raw() / kWordsPerLine));
    in_id_read_.push() = slot;
  }
  void take_id_line() {
    if (in_id_read_.empty() || !ports_.ids.answers->can_pop()) return;
    const std::size_t slot = take(in_id_read_);
    rays_[slot].id_line = ports_.ids.answers->pop().words;
    to_emit_.push() = slot;
  }

  /// An entry a clock; a leaf that goes on in the next line waits for that.
  void emit_candidate() {
    if (to_emit_.empty() || !ports_.candidates.can_push()) return;
    const std::size_t slot = to_emit_.front();
    State& ray = rays_[slot];
    const Pointer index = ray.current.pointer;
    const UInt<32> word = ray.id_line[index.raw() % kWordsPerLine];
    const UInt<1> last = bits<31, 31>(word);
    ports_.candidates.push(
        {ray.job.number, RaySlot(slot), index, bits<kPointerBits - 1, 0>(word), last, ray.current.entry});
    ray.current.pointer = Pointer::of_raw(index.raw() + 1);
    if (last) {
      to_emit_.pop();
    } else if (taken<Bits>(Corner::ray_leaf_crosses_lines, ray.current.pointer.raw() % kWordsPerLine == 0)) {
      to_read_ids_.push() = take(to_emit_);
    }
  }

  void take_reply() {
    if (!ports_.replies.can_pop()) return;
    const LeafReply& reply = ports_.replies.pop();
    const std::size_t slot = reply.slot.raw();
    State& ray = rays_[slot];
    ray.t_max = lower_float(smaller_float<Bits>(lift<Bits>(ray.t_max), lift<Bits>(reply.t)));
    (reply.stop ? to_report_ : to_pop_).push() = slot;
  }

  void report() {
    if (to_report_.empty() || !ports_.reports.can_push()) return;
    const std::size_t slot = take(to_report_);
    rays_[slot].report.t_max = rays_[slot].t_max;
    ports_.reports.push(rays_[slot].report);
    free_.push() = slot;
  }

  RaySchedulerPorts<N> ports_;
  RayTree<N> tree_;
  std::vector<State> rays_;
  Slots free_;
  Slots in_setup_;
  Slots to_fetch_;
  Slots in_fetch_;
  Slots to_test_;
  Slots in_test_;
  Slots to_pop_;
  Slots to_read_ids_;
  Slots in_id_read_;
  Slots to_emit_;
  Slots to_report_;
};

}  // namespace cbvh::rtl
