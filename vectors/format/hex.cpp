// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/hex.h"

#include <algorithm>

#include "vectors/format/line_reader.h"
#include "vectors/format/printable.h"

namespace cbvh::vectors {
namespace {

constexpr std::string_view kMark = "// ";
enum Kind : char { kNextStimulus = '0', kFirstStimulus = '1', kResponse = '2' };

/// Digits of every word, without the first.
std::size_t payload_digits(const PayloadCodec& stimulus, const PayloadCodec& response) {
  return (std::max(stimulus.width, response.width) + 3) / 4;
}

class HexReader final : public LineReader {
 public:
  HexReader(std::string_view bytes, const std::string& name)
      : LineReader(bytes, name, kMark),
        stimulus_(unit_->stimulus(parameters_.bits)),
        response_(unit_->response(parameters_.bits)),
        digits_(payload_digits(stimulus_, response_)),
        packed_(digits_ / 2 + 1) {}

 private:
  void read_case(VectorSet& batch) override {
    // The word of the first stimulus comes before the id and class that it belongs to.
    if (!next_is(kFirstStimulus)) fail(at_, fmt::format("found {}, want a case's first stimulus, '1_'", found()));
    const char* const word = at_;
    at_ += std::min(left(), digits_ + 2);
    expect(" // ");
    read_head(batch);
    const char* const after = at_;
    at_ = word;
    read_word(stimulus_, batch.add_stimulus());
    at_ = after;
    end_line();
    while (unit_->stateful && next_is(kNextStimulus)) {
      read_word(stimulus_, batch.add_stimulus());
      end_line();
    }
    if (!unit_->stateful && !next_is(kResponse)) fail(at_, fmt::format("found {}, want a response, '2_'", found()));
    while (next_is(kResponse)) {
      const auto slot = batch.add_response();
      read_word(response_, slot.response);
      expect(" // ");
      *slot.latency = read_latency();
      end_line();
      if (!unit_->stateful) return;
    }
  }

  bool next_is(Kind kind) const { return left() > 0 && *at_ == kind; }
  std::string found() const { return printable(word_at(at_)); }

  void read_word(const PayloadCodec& codec, void* payload) {
    ++at_;
    expect("_");
    const std::string_view word = word_at(at_);
    if (word.size() != digits_) fail(at_, fmt::format("{} hex digits, want {}", word.size(), digits_));
    std::fill(packed_.begin(), packed_.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < digits_; ++i) {
      const std::uint8_t digit = detail::kDigitValues[static_cast<std::uint8_t>(word[digits_ - 1 - i])];
      if (digit == detail::kNoDigit) fail(at_ + (digits_ - 1 - i), "not a hex digit");
      packed_[i / 2] = static_cast<std::uint8_t>(packed_[i / 2] | (digit << (4 * (i % 2))));
    }
    const auto is_zero = [](std::uint8_t byte) { return byte == 0; };
    const auto padding = packed_.begin() + static_cast<std::ptrdiff_t>(codec.packed_bytes());
    if (!codec.unpack(packed_.data(), payload) || !std::all_of(padding, packed_.end(), is_zero)) {
      fail(at_, fmt::format("a value that does not fit {} bits", codec.width));
    }
    at_ += digits_;
  }

  const PayloadCodec& stimulus_;
  const PayloadCodec& response_;
  const std::size_t digits_;
  std::vector<std::uint8_t> packed_;
};

/// "2_" and the word.
void append_word(Output& output, Kind kind, const PayloadCodec& codec, const void* payload, std::size_t digits,
                 std::vector<std::uint8_t>& packed) {
  packed.assign(digits / 2 + 1, 0);
  codec.pack(payload, packed.data());
  output.buffer().push_back(kind);
  output.buffer().push_back('_');
  for (std::size_t i = digits; i-- > 0;) {
    output.buffer().push_back("0123456789ABCDEF"[(packed[i / 2] >> (4 * (i % 2))) & 0xF]);
  }
}

}  // namespace

void write_hex(const VectorSet& set, Output& output) {
  const PayloadCodec& stimulus = set.stimulus_codec();
  const PayloadCodec& response = set.response_codec();
  const std::size_t digits = payload_digits(stimulus, response);
  std::vector<std::uint8_t> packed;
  output.append(fmt::format("{}{}\n", kMark, header_line(set)));
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto stimuli = set.stimulus_range(i);
    for (std::size_t s = 0; s < stimuli.size; ++s) {
      append_word(output, s == 0 ? kFirstStimulus : kNextStimulus, stimulus, set.stimulus_at(stimuli.begin + s), digits,
                  packed);
      if (s == 0) {
        fmt::format_to(std::back_inserter(output.buffer()), " // {} {}", set.head(i).id, set.class_name(i));
      }
      output.append("\n");
    }
    const auto responses = set.response_range(i);
    for (std::size_t r = 0; r < responses.size; ++r) {
      append_word(output, kResponse, response, set.response_at(responses.begin + r), digits, packed);
      const std::uint32_t latency = set.latency_at(responses.begin + r);
      output.append(latency == kLatencyNotStated ? " // @-\n" : fmt::format(" // @{}\n", latency));
    }
    output.flush_when_large();
  }
  output.append(kMark);
  output.append(trailer_line(set.counts()));
  const std::uint32_t crc = output.crc();
  output.append(fmt::format("{:08X}\n", crc));
}

std::unique_ptr<SetReader> read_hex(std::string_view bytes, const std::string& name) {
  return std::make_unique<HexReader>(bytes, name);
}

}  // namespace cbvh::vectors
