// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/text.h"

#include <limits>

#include "vectors/format/line_reader.h"
#include "vectors/format/printable.h"

namespace cbvh::vectors {
namespace {

constexpr std::string_view kMark = "# ";

void append_payload(fmt::memory_buffer& buffer, const PayloadCodec& codec, const void* payload) {
  const std::size_t start = buffer.size();
  buffer.resize(start + codec.text_length);
  codec.print_text(payload, buffer.data() + start);
}

void append_latency(Output& output, std::uint32_t latency) {
  if (latency == kLatencyNotStated) {
    output.append(" @-\n");
  } else {
    fmt::format_to(std::back_inserter(output.buffer()), FMT_STRING(" @{}\n"), latency);
  }
}

class TextReader final : public LineReader {
 public:
  TextReader(std::string_view bytes, const std::string& name)
      : LineReader(bytes, name, kMark),
        stimulus_(unit_->stimulus(parameters_.bits)),
        response_(unit_->response(parameters_.bits)) {}

 private:
  void read_case(VectorSet& batch) override {
    read_head(batch);
    if (!unit_->stateful) {
      expect(" ");
      read_payload(stimulus_, batch.add_stimulus());
      read_response(batch, " > ");
      return;
    }
    expect(" episode ");
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    const char* const start = at_;
    const std::uint64_t stimuli = read_number("stimuli", kMost);
    if (stimuli == 0) fail(start, "an episode without stimuli");
    expect(" ");
    const std::uint64_t responses = read_number("responses", kMost);
    end_line();
    for (std::uint64_t i = 0; i < stimuli; ++i) {
      expect("< ");
      read_payload(stimulus_, batch.add_stimulus());
      end_line();
    }
    for (std::uint64_t i = 0; i < responses; ++i) read_response(batch, "> ");
  }

  void read_response(VectorSet& batch, std::string_view mark) {
    expect(mark);
    const auto slot = batch.add_response();
    read_payload(response_, slot.response);
    expect(" ");
    *slot.latency = read_latency();
    end_line();
  }

  void read_payload(const PayloadCodec& codec, void* payload) {
    if (left() < codec.text_length || !codec.parse_text(at_, payload)) explain(codec);
    at_ += codec.text_length;
  }

  /// Says what is wrong with the payload at the cursor.
  [[noreturn]] void explain(const PayloadCodec& codec) {
    for (const auto& leaf : codec.leaves) {
      const std::string_view word = word_at(at_);
      const auto digits = static_cast<std::size_t>(hex_digits(leaf.width));
      const auto complain = [&](const std::string& what) { fail(at_, fmt::format("field '{}': {}", leaf.name, what)); };
      if (word.empty() || word == ">" || word.front() == '@') complain("missing");
      unsigned bad = 0;
      std::uint64_t value = 0;
      for (const char c : word) {
        const std::uint8_t digit = detail::kDigitValues[static_cast<std::uint8_t>(c)];
        bad |= digit & detail::kNoDigit;
        value = (value << 4) | (digit & 0xFU);
      }
      if (bad != 0) complain(fmt::format("{} is not a hex number", printable(word)));
      if (word.size() != digits) complain(fmt::format("{} hex digits, want {}", word.size(), digits));
      if (leaf.width < 64 && (value >> leaf.width) != 0)
        complain(fmt::format("{} does not fit {} bits", word, leaf.width));
      at_ += word.size();
      if (&leaf != &codec.leaves.back()) expect(" ");
    }
    fail(at_, "malformed fields");
  }

  const PayloadCodec& stimulus_;
  const PayloadCodec& response_;
};

}  // namespace

void write_text(const VectorSet& set, Output& output) {
  const PayloadCodec& stimulus = set.stimulus_codec();
  const PayloadCodec& response = set.response_codec();
  fmt::memory_buffer& buffer = output.buffer();
  output.append(kMark);
  output.append(header_line(set));
  output.append("\n");
  for (std::size_t i = 0; i < set.size(); ++i) {
    fmt::format_to(std::back_inserter(buffer), FMT_STRING("{} {} "), set.head(i).id, set.class_name(i));
    const auto stimuli = set.stimulus_range(i);
    const auto responses = set.response_range(i);
    const bool stateful = set.unit().stateful;
    if (stateful) {
      fmt::format_to(std::back_inserter(buffer), FMT_STRING("episode {} {}\n"), stimuli.size, responses.size);
    }
    for (std::size_t s = 0; s < stimuli.size; ++s) {
      if (stateful) output.append("< ");
      append_payload(buffer, stimulus, set.stimulus_at(stimuli.begin + s));
      output.append(stateful ? "\n" : " ");
    }
    for (std::size_t r = 0; r < responses.size; ++r) {
      output.append("> ");
      append_payload(buffer, response, set.response_at(responses.begin + r));
      append_latency(output, set.latency_at(responses.begin + r));
    }
    output.flush_when_large();
  }
  output.append(kMark);
  output.append(trailer_line(set.counts()));
  const std::uint32_t crc = output.crc();
  output.append(fmt::format("{:08X}\n", crc));
}

std::unique_ptr<SetReader> read_text(std::string_view bytes, const std::string& name) {
  return std::make_unique<TextReader>(bytes, name);
}

}  // namespace cbvh::vectors
