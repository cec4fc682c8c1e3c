// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/record_words.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Writes the primitive-ID array: sixteen entries a line from `base` on, of the last line only the words that are used.
/// An entry a clock; a line leaves in the clock of its sixteenth entry. Reports when memory has acknowledged the last
/// line. Holds one line. Paper section 5.
class IdWriter {
 public:
  IdWriter(Channel<IdEntry>& entries, Channel<LineRequest>& requests, Channel<LineData>& answers,
           Channel<WriteReport>& reports, LineAddress base)
      : entries_(entries), requests_(requests), answers_(answers), reports_(reports), base_(base) {}

  void tick() {
    if (finishing_) return finish();
    if (!entries_.can_pop() || !requests_.can_push()) return;
    const IdEntry& entry = entries_.pop();
    const std::size_t slot = items_ % kWordsPerLine;
    line_.words[slot] = id_word(entry);
    line_.mask = line_.mask | UInt<kWordsPerLine>(std::uint64_t{1} << slot);
    ++items_;
    if (slot + 1 == kWordsPerLine || entry.last) send(entry.last);
  }
  void commit(CommitKey) {}

 private:
  void send(UInt<1> last) {
    line_.write = UInt<1>(1);
    line_.acknowledge = last;
    line_.line = LineAddress(base_.value() + lines_++);
    requests_.push(line_);
    line_ = {};
    finishing_ = bool(last);
  }
  void finish() {
    if (!answers_.can_pop() || !reports_.can_push()) return;
    answers_.pop();
    reports_.push({UInt<kPointerBits + 1>(items_), UInt<32>(lines_)});
    items_ = lines_ = 0;
    finishing_ = false;
  }

  Channel<IdEntry>& entries_;
  Channel<LineRequest>& requests_;
  Channel<LineData>& answers_;
  Channel<WriteReport>& reports_;
  const LineAddress base_;
  LineRequest line_;  ///< being filled
  std::uint64_t items_ = 0;
  std::uint64_t lines_ = 0;
  bool finishing_ = false;
};

}  // namespace cbvh::rtl
