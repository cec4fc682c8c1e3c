// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/record_words.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Writes sorted runs to memory, two records a line, a record a clock. An area says where the runs of a pass go: one
/// after the other from its first line on, each beginning with a line of its own. Then, with the last record of the
/// pass, it waits for the next area. A run is told when its last line is on its way; the last run of the pass when
/// memory has acknowledged its last line, so that everything may be read. Latency of a line 1. Paper section 5.3.
class RunWriter {
 public:
  RunWriter(Channel<RunArea>& areas, Channel<SortItem>& items, Channel<LineRequest>& requests,
            Channel<LineData>& answers, Channel<RunDescriptor>& runs)
      : areas_(areas), items_(items), requests_(requests), answers_(answers), runs_(runs) {}

  void tick() {
    switch (state_) {
      case State::idle:
        if (!areas_.can_pop()) return;
        area_ = areas_.pop();
        begin_run(area_.first_line);
        state_ = State::writing;
        return;
      case State::writing:
        if (items_.can_pop()) write(items_.front());
        return;
      case State::acknowledging:
        if (!answers_.can_pop() || !runs_.can_push()) return;
        answers_.pop();
        runs_.push(run_);
        state_ = State::idle;
        return;
    }
  }
  void commit(CommitKey) {}

  /// For the driver: runs so far whose last line is half empty.
  std::uint64_t odd_runs() const { return odd_runs_; }

 private:
  enum class State { idle, writing, acknowledging };
  static constexpr std::uint64_t kRecordMask = (1U << kWordsPerRecord) - 1;

  void begin_run(LineAddress first_line) {
    run_ = {first_line, {}, {}};
    begin_line(first_line);
  }
  void begin_line(LineAddress line) { line_ = {UInt<1>(1), {}, line, {}, {}}; }

  void write(const SortItem& item) {
    const std::uint64_t record_of_line = run_.records.value() % kRecordsPerLine;
    const bool ends_run = bool(item.last_of_run) || bool(item.last);
    const bool ends_line = ends_run || record_of_line + 1 == kRecordsPerLine;
    const bool tells_run = ends_run && !item.last;
    if ((ends_line && !requests_.can_push()) || (tells_run && !runs_.can_push())) return;
    put_record(item.record, line_.words, record_of_line);
    line_.mask = line_.mask | UInt<kWordsPerLine>(kRecordMask << (record_of_line * kWordsPerRecord));
    run_.records = truncate<kPointerBits + 1>(run_.records + UInt<1>(1));
    if (ends_line) {
      line_.acknowledge = item.last;
      requests_.push(line_);
      begin_line(truncate<kLineAddressBits>(line_.line + UInt<1>(1)));
    }
    if (ends_run) odd_runs_ += run_.records.value() % kRecordsPerLine;
    if (tells_run) {
      runs_.push(run_);
      begin_run(truncate<kLineAddressBits>(line_.line + area_.padding));
    }
    if (item.last) {
      run_.last = UInt<1>(1);
      state_ = State::acknowledging;
    }
    items_.pop();
  }

  Channel<RunArea>& areas_;
  Channel<SortItem>& items_;
  Channel<LineRequest>& requests_;
  Channel<LineData>& answers_;
  Channel<RunDescriptor>& runs_;
  State state_ = State::idle;
  RunArea area_;
  RunDescriptor run_;  ///< the run that is being written
  LineRequest line_;   ///< the line that is being filled
  std::uint64_t odd_runs_ = 0;
};

}  // namespace cbvh::rtl
