// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cassert>
#include <optional>
#include <vector>

#include "rtl_model/datapath/record_words.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/fifo.h"
#include "rtl_model/lbvh/merge_config.h"
#include "rtl_model/lbvh/tournament_tree.h"

namespace cbvh::rtl {

/// The scratchpad of the run merger, divided evenly into a ring of lines for each run, and the reads that fill it.
///
/// A record leaves its ring when the tournament takes it, and waits for its end in a store of two records a node: so a
/// run that is dry is always being refilled, whatever the tournament waits for.
///
/// Refills go out in batches of consecutive lines, first come first served: a run is queued while it has room for a
/// batch, at the end of the queue again after each. The first batch of every run goes before all others. When memory is
/// slower than the merge the queue is never empty and every read in it is needed sooner or later, so nothing is lost to
/// an order that could know better which run will be dry first; when memory is faster the queue is empty and there is
/// nothing to order.
///
/// Memories: the scratchpad, a line in and a record out a clock; the store, a record in and out; the codes once more,
/// in two banks for even and odd runs; the pointers of each run; the queue, a number a run; the runs of the lines under
/// way. A part of the run merger, which ticks it.
template <class Bits>
class RunBuffers {
 public:
  RunBuffers(Channel<LineRequest>& requests, Channel<LineData>& answers, const MergeConfig& config)
      : requests_(requests),
        answers_(answers),
        config_(config),
        lines_(config.scratchpad_lines()),
        orders_(config.scratchpad_lines() * kRecordsPerLine),
        store_(2 * std::bit_ceil(config.most_runs())),
        free_slots_(store_.size()),
        runs_(config.most_runs()),
        queue_(config.most_runs()),
        under_way_(config.outstanding) {
    for (std::uint32_t slot = 0; slot < store_.size(); ++slot) free_slots_.push() = slot;
  }

  /// Prepares for a merge of so many runs, which are then opened one a clock.
  void start(std::size_t runs) {
    assert(queue_.empty() && under_way_.empty());
    shape_ = BufferShape::of(config_, runs);
    run_count_ = runs;
    opened_ = begun_ = 0;
  }
  void open(const RunDescriptor& run) {
    const std::uint64_t records = run.records.value();
    Run& opened = runs_[opened_];
    opened = {};
    opened.next_line = run.first_line.value();
    opened.unasked_lines = (records + 1) / kRecordsPerLine;
    opened.missing_records = records;
    opened.free_batches = shape_.buffer_lines / shape_.batch_lines;
    opened.queued = true;
    ++opened_;
  }

  /// Asks for a line, if one is wanted. Before anything else of the clock.
  void request() {
    queue_written_ = false;
    if (batch_lines_left_ == 0) next_batch();
    if (batch_lines_left_ == 0 || under_way_.free() == 0 || !requests_.can_push()) return;
    if (batch_lines_left_ == 1 && queued_again_) return;
    Run& run = runs_[batch_run_];
    LineRequest read;
    read.line = LineAddress(run.next_line++);
    requests_.push(read);
    under_way_.push() = batch_run_;
    --run.unasked_lines;
    if (--batch_lines_left_ == 0) {
      --run.free_batches;
      queued_again_ = batch_run_;
      next_batch();
    }
  }
  /// Takes a line that memory has answered, and queues again the run that had a batch. After everything else of the
  /// clock.
  void receive() {
    if (queued_again_ && !queue_written_) {
      Run& run = runs_[*queued_again_];
      run.queued = false;
      if (wants_batch(run)) enqueue(*queued_again_);
      queued_again_.reset();
    }
    if (!answers_.can_pop()) return;
    const std::size_t index = under_way_.front();
    under_way_.pop();
    Run& run = runs_[index];
    const std::size_t line = index * shape_.buffer_lines + run.write_line;
    lines_[line] = answers_.pop().words;
    for (std::size_t slot = 0; slot < kRecordsPerLine; ++slot)
      orders_[line * kRecordsPerLine + slot] = truncate<kMortonBits>(lines_[line][slot * kWordsPerRecord + 6]);
    run.write_line = run.write_line + 1 == shape_.buffer_lines ? 0 : run.write_line + 1;
    const bool half = taken<Bits>(Corner::merger_half_line, run.missing_records == 1);
    const std::uint64_t records = half ? 1 : kRecordsPerLine;
    run.missing_records -= records;
    run.filled_records += records;
  }

  /// What the tournament sees of the runs. Those beyond the last are at their end.
  bool dry(std::size_t index) const {
    if (index >= run_count_) return false;
    return index >= opened_ || (runs_[index].filled_records == 0 && runs_[index].missing_records > 0);
  }
  MergeOrder order(std::size_t index) const { return at_end(index) ? kMergeEnd : orders_[place(index)]; }
  /// The run's next record goes into the store. At most once a clock.
  MergeKey take(std::size_t index) {
    if (at_end(index)) return {kMergeEnd, 0};
    const std::size_t from = place(index);
    Run& run = runs_[index];
    --run.filled_records;
    run.read_record = run.read_record + 1 == shape_.buffer_lines * kRecordsPerLine ? 0 : run.read_record + 1;
    if (run.read_record % kRecordsPerLine == 0) free_line(index);
    const std::uint32_t slot = free_slots_.front();
    free_slots_.pop();
    store_[slot] = record_at(lines_[from / kRecordsPerLine], from % kRecordsPerLine);
    return {orders_[from], slot};
  }

  /// The record of a key that has won. At most once a clock.
  const SortRecord& release(const MergeKey& key) {
    free_slots_.push() = key.slot;
    return store_[key.slot];
  }

 private:
  struct Run {
    std::uint64_t next_line = 0;  ///< in memory
    std::uint64_t unasked_lines = 0;
    std::uint64_t missing_records = 0;  ///< not in the buffer yet
    std::uint64_t filled_records = 0;   ///< in the buffer and not in the tournament yet
    std::uint64_t write_line = 0;       ///< in the buffer
    std::uint64_t read_record = 0;      ///< likewise
    std::uint64_t free_batches = 0;
    std::uint64_t freed_lines = 0;  ///< of a batch that is not free as a whole
    bool queued = false;            ///< or being asked for
  };

  bool at_end(std::size_t index) const { return index >= run_count_ || runs_[index].filled_records == 0; }
  /// Of the run's next record.
  std::size_t place(std::size_t index) const {
    return index * shape_.buffer_lines * kRecordsPerLine + runs_[index].read_record;
  }
  static bool wants_batch(const Run& run) { return run.free_batches > 0 && run.unasked_lines > 0; }
  /// At most once a clock.
  void enqueue(std::size_t index) {
    assert(!queue_written_);
    queue_written_ = true;
    runs_[index].queued = true;
    queue_.push() = index;
  }
  void next_batch() {
    if (begun_ < opened_) {
      batch_run_ = begun_++;
    } else if (!queue_.empty()) {
      batch_run_ = queue_.front();
      queue_.pop();
    } else {
      return;
    }
    batch_lines_left_ = std::min(shape_.batch_lines, runs_[batch_run_].unasked_lines);
  }
  void free_line(std::size_t index) {
    Run& run = runs_[index];
    if (++run.freed_lines < shape_.batch_lines) return;
    run.freed_lines = 0;
    ++run.free_batches;
    if (!run.queued && wants_batch(run)) enqueue(index);
  }

  Channel<LineRequest>& requests_;
  Channel<LineData>& answers_;
  const MergeConfig config_;
  std::vector<LineWords> lines_;
  std::vector<MergeOrder> orders_;
  std::vector<SortRecord> store_;   ///< records in the tournament
  Fifo<std::uint32_t> free_slots_;  ///< of the store
  std::vector<Run> runs_;
  Fifo<std::size_t> queue_;      ///< runs that want a batch, each once
  Fifo<std::size_t> under_way_;  ///< the run of each line asked for
  BufferShape shape_{1, 1};
  std::size_t run_count_ = 0;
  std::size_t opened_ = 0;
  std::size_t begun_ = 0;      ///< runs whose first batch has been asked for
  std::size_t batch_run_ = 0;  ///< the batch being asked for
  std::uint64_t batch_lines_left_ = 0;
  std::optional<std::size_t> queued_again_;  ///< the run that had the batch before
  bool queue_written_ = false;               ///< in this clock
};

}  // namespace cbvh::rtl
