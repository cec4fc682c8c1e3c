// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/lbvh_payloads.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Reads the primitives of a scene, which lie one after the other from the first word of a line on: a line a clock at
/// most, `outstanding` lines asked for and not yet looked at, a primitive a clock while there is data. A primitive is
/// given 1 clock after its last line was taken. Memory: two lines of words, beside the answers that wait at the port.
/// 40 bytes of traffic a primitive, paper section 5.3.
class PrimitiveReader {
 public:
  /// Configuration wires: `count` primitives, at least one, from `first_line` on.
  PrimitiveReader(Channel<LineRequest>& requests, Channel<LineData>& answers, Channel<Primitive>& primitives,
                  LineAddress first_line, std::uint64_t count, unsigned outstanding = 32)
      : requests_(requests),
        answers_(answers),
        primitives_(primitives),
        next_line_(first_line.value()),
        end_line_(next_line_ + (count * kWordsPerPrimitive + kWordsPerLine - 1) / kWordsPerLine),
        primitives_left_(count),
        outstanding_(outstanding) {}

  void tick() {
    if (next_line_ < end_line_ && in_flight_ < outstanding_ && requests_.can_push()) ask();
    const bool gives = words_held_ >= kWordsPerPrimitive && primitives_left_ > 0 && primitives_.can_push();
    if (gives) give();
    if (words_held_ <= kWindow - kWordsPerLine && answers_.can_pop()) take(answers_.pop());
  }
  void commit(CommitKey) {}

 private:
  static constexpr std::size_t kWindow = 2 * kWordsPerLine;

  void ask() {
    LineRequest request;
    request.line = LineAddress(next_line_++);
    requests_.push(request);
    ++in_flight_;
  }
  void give() {
    const auto word = [this](std::size_t index) { return window_[(first_word_ + index) % kWindow].value(); };
    Primitive primitive;
    for (std::size_t i = 0; i < 9; ++i) primitive.vertex[i / 3][i % 3] = Float32::of_raw(word(i));
    primitive.id = Pointer::of_raw(word(9));
    primitive.last = UInt<1>(--primitives_left_ == 0);
    primitives_.push(primitive);
    first_word_ = (first_word_ + kWordsPerPrimitive) % kWindow;
    words_held_ -= kWordsPerPrimitive;
  }
  void take(const LineData& line) {
    for (std::size_t i = 0; i < kWordsPerLine; ++i) {
      window_[(first_word_ + words_held_ + i) % kWindow] = line.words[i];
    }
    words_held_ += kWordsPerLine;
    --in_flight_;
  }

  Channel<LineRequest>& requests_;
  Channel<LineData>& answers_;
  Channel<Primitive>& primitives_;
  std::uint64_t next_line_;  ///< to be asked for
  std::uint64_t end_line_;
  std::uint64_t primitives_left_;  ///< to be given
  unsigned outstanding_;
  unsigned in_flight_ = 0;
  std::array<UInt<32>, kWindow> window_;  ///< words that came and are not given yet
  std::size_t first_word_ = 0;
  std::size_t words_held_ = 0;
};

}  // namespace cbvh::rtl
