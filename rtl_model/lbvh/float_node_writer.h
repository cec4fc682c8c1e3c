// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/record_words.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Writes node pairs as they are, in binary32: pair i is line `base` + i. What an LBVH builder without compression
/// does. A pair a clock. Reports when memory has acknowledged the root pair. Holds nothing. Paper sections 5.2 and 5.3,
/// the baseline.
class FloatNodeWriter {
 public:
  FloatNodeWriter(Channel<StreamJob>& jobs, Channel<LineRequest>& requests, Channel<LineData>& answers,
                  Channel<WriteReport>& reports, LineAddress base)
      : jobs_(jobs), requests_(requests), answers_(answers), reports_(reports), base_(base) {}

  void tick() {
    if (finishing_) return finish();
    if (!jobs_.can_pop() || !requests_.can_push()) return;
    const StreamJob& job = jobs_.pop();
    const LineAddress line(base_.value() + pairs_++);
    requests_.push({UInt<1>(1), job.root, line, kAllWords, float_pair_words(job.pair)});
    finishing_ = bool(job.root);
  }
  void commit(CommitKey) {}

 private:
  static constexpr UInt<kWordsPerLine> kAllWords{low_mask(kWordsPerLine)};

  void finish() {
    if (!answers_.can_pop() || !reports_.can_push()) return;
    answers_.pop();
    reports_.push({UInt<kPointerBits + 1>(pairs_), UInt<32>(pairs_)});
    pairs_ = 0;
    finishing_ = false;
  }

  Channel<StreamJob>& jobs_;
  Channel<LineRequest>& requests_;
  Channel<LineData>& answers_;
  Channel<WriteReport>& reports_;
  const LineAddress base_;
  std::uint64_t pairs_ = 0;
  bool finishing_ = false;
};

}  // namespace cbvh::rtl
