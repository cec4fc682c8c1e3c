// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/lbvh_payloads.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/memory/line_reads.h"

namespace cbvh::rtl {

/// Reads the primitives of a scene, which lie one after the other from the first word of a line on: a line a clock at
/// most, at most `outstanding` of them asked for and not used yet. A primitive a clock while there is data; it is given
/// 1 clock after its last line came. Memory: `outstanding` lines of 512 bits, and a window of two lines from which any
/// ten words can be taken. 40 bytes of traffic a primitive, paper section 5.3.
class PrimitiveReader {
 public:
  /// Configuration wires: `count` primitives, at least one, from `first_line` on.
  PrimitiveReader(Channel<LineRequest>& requests, Channel<LineData>& answers, Channel<Primitive>& primitives,
                  LineAddress first_line, std::uint64_t count, std::size_t outstanding = 32)
      : reads_({&requests, &answers}, outstanding),
        primitives_(primitives),
        next_line_(first_line.value()),
        end_line_(next_line_ + (count * kWordsPerPrimitive + kWordsPerLine - 1) / kWordsPerLine),
        primitives_left_(count) {}

  void tick() {
    reads_.take_answer();
    if (next_line_ < end_line_ && reads_.can_request()) reads_.request(LineAddress(next_line_++));
    if (words_held_ >= kWordsPerPrimitive && primitives_left_ > 0 && primitives_.can_push()) give();
    if (words_held_ <= kWindow - kWordsPerLine && reads_.has_line()) take_line();
  }
  void commit(CommitKey) {}

 private:
  static constexpr std::size_t kWindow = std::size_t{2} * kWordsPerLine;

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
  void take_line() {
    for (std::size_t i = 0; i < kWordsPerLine; ++i) {
      window_[(first_word_ + words_held_ + i) % kWindow] = reads_.line()[i];
    }
    words_held_ += kWordsPerLine;
    reads_.drop_line();
  }

  LineReads reads_;
  Channel<Primitive>& primitives_;
  std::uint64_t next_line_;  ///< to be asked for
  std::uint64_t end_line_;
  std::uint64_t primitives_left_;         ///< to be given
  std::array<UInt<32>, kWindow> window_;  ///< words that came and are not given yet
  std::size_t first_word_ = 0;
  std::size_t words_held_ = 0;
};

}  // namespace cbvh::rtl
