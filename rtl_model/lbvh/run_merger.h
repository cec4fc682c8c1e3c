// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

#include "rtl_model/lbvh/run_buffers.h"
#include "rtl_model/lbvh/tournament_tree.h"

namespace cbvh::rtl {

/// Merges the sorted runs of a scene, equal codes in the order of the runs. A record a clock while no buffer is dry.
///
/// Runs arrive as descriptors, each of one record at least, into a table; with the last one the merging begins. If
/// there are more than can be merged at once, then first as few as must be are merged in groups of consecutive runs.
/// These leave at `rewritten`, the end of each group marked last_of_run, that of the last group `last`; whoever writes
/// them sends their descriptors to `runs`, again the last one marked. This is repeated while there are too many. Then
/// the scene leaves at `sorted`, and the runs of another one may come.
///
/// Memories: the scratchpad and two records a run in the tournament (run_buffers.h), the tournament's keys, the table.
/// Opening takes a clock a run; reads go out from the first one on. The first record leaves a clock a level of the
/// tournament after the last run's first lines are here. Paper sections 5.2 and 5.3, after [VKJ*15].
template <class Bits>
class RunMerger {
 public:
  /// `config` is consistent.
  RunMerger(Channel<RunDescriptor>& runs, Channel<LineRequest>& requests, Channel<LineData>& answers,
            Channel<SortItem>& sorted, Channel<SortItem>& rewritten, const MergeConfig& config)
      : descriptors_(runs),
        sorted_(sorted),
        rewritten_(rewritten),
        most_runs_(config.most_runs()),
        table_(config.table_runs),
        buffers_(requests, answers, config),
        tree_(config.most_runs()) {
    assert(config.inconsistent_field().empty());
  }

  void tick() {
    if (merging_) {
      merge();
    } else if (pass_left_ > 0) {
      begin_group();
    } else if (complete_) {
      begin_pass();
    }
    if (descriptors_.can_pop() && !final_) take_descriptor(descriptors_.pop());
  }
  void commit(CommitKey) {}

 private:
  void take_descriptor(const RunDescriptor& run) {
    assert(arrived_ < table_.size());
    table_[arrived_++] = run;
    complete_ = bool(run.last);
  }

  /// Merging m runs into one leaves m - 1 fewer: merges as many as bring the rest down to what can be merged at once,
  /// or all of them.
  void begin_pass() {
    const std::size_t total = arrived_ + kept_;
    complete_ = false;
    pass_begin_ = 0;
    final_ = !taken<Bits>(Corner::merger_rewrites, total > most_runs_);
    pass_left_ = total;
    if (final_) return;
    const std::size_t surplus = total - most_runs_;
    const std::size_t groups = (surplus + most_runs_ - 2) / (most_runs_ - 1);
    pass_left_ = std::min(total, surplus + groups);
    first_kept_ = pass_left_;
    kept_ = total - pass_left_;
    arrived_ = 0;
  }
  void begin_group() {
    group_runs_ = std::min(pass_left_, most_runs_);
    pass_left_ -= group_runs_;
    opened_ = 0;
    records_left_ = 0;
    buffers_.start(group_runs_);
    tree_.start(group_runs_);
    merging_ = true;
  }

  void merge() {
    buffers_.request();
    if (opened_ < group_runs_) {
      open_run();
    } else {
      send_record();
    }
    tree_.tick(buffers_);
    buffers_.receive();
  }
  /// Descriptors that come back during a pass take the place of runs that are open or merged already. The runs that a
  /// pass left alone come behind them, and only in the final merge.
  void open_run() {
    const std::size_t index = pass_begin_++;
    ++opened_;
    const bool kept = final_ && index >= arrived_;
    const RunDescriptor& run = table_[kept ? first_kept_ + index - arrived_ : index];
    records_left_ += run.records.value();
    buffers_.open(run);
  }
  void send_record() {
    if (taken<Bits>(Corner::merger_waits, !tree_.can_pop())) return;
    Channel<SortItem>& output = final_ ? sorted_ : rewritten_;
    if (!output.can_push()) return;
    const bool last_of_run = --records_left_ == 0;
    const bool last = last_of_run && pass_left_ == 0;
    output.push({buffers_.release(tree_.pop()), UInt<1>(last_of_run), UInt<1>(last)});
    if (!last_of_run) return;
    merging_ = false;
    if (!final_) return;
    final_ = false;
    arrived_ = kept_ = 0;
  }

  Channel<RunDescriptor>& descriptors_;
  Channel<SortItem>& sorted_;
  Channel<SortItem>& rewritten_;
  const std::size_t most_runs_;
  std::vector<RunDescriptor> table_;
  RunBuffers<Bits> buffers_;
  TournamentTree<Bits> tree_;
  std::size_t arrived_ = 0;  ///< descriptors of the next pass
  std::size_t first_kept_ = 0;
  std::size_t kept_ = 0;        ///< runs that the last pass left alone
  std::size_t pass_begin_ = 0;  ///< the first run of this pass that is not open yet
  std::size_t pass_left_ = 0;   ///< runs of this pass in groups not begun
  std::size_t group_runs_ = 0;
  std::size_t opened_ = 0;          ///< runs of this group
  std::uint64_t records_left_ = 0;  ///< of this group
  bool complete_ = false;           ///< all descriptors of the next pass are here
  bool final_ = false;
  bool merging_ = false;
};

}  // namespace cbvh::rtl
