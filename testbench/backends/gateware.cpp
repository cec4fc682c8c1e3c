// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "testbench/backend/backend.h"
#include "testbench/gateware/simulator.h"
#include "testbench/unavailable.h"

namespace cbvh::testbench {

namespace {

struct Given {
  std::uint64_t cycle;
  std::string_view digits;  ///< of the response; x where the Verilog gave no value
};

/// What one case did, of a trace.
struct CaseTrace {
  std::vector<std::uint64_t> accepted;
  std::vector<Given> given;
  std::uint64_t cycles = 0;
  bool hung = false;
};

std::uint64_t number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::runtime_error(fmt::format("vvp: '{}' in the trace is no number", text));
  }
  return value;
}

std::string_view take_word(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

std::vector<CaseTrace> parse_trace(std::string_view text) {
  std::vector<CaseTrace> cases;
  CaseTrace current;
  while (!text.empty()) {
    std::string_view line = take_word(text, '\n');
    const std::string_view kind = take_word(line, ' ');
    if (kind == "a") {
      current.accepted.push_back(number(line));
    } else if (kind == "r") {
      const std::uint64_t cycle = number(take_word(line, ' '));
      current.given.push_back({cycle, line});
    } else if (kind == "e") {
      current.cycles = number(take_word(line, ' '));
      current.hung = number(line) != 0;
      cases.push_back(std::move(current));
      current = {};
    }
  }
  return cases;
}

/// Responses of a set, made from the digits of a trace.
class Reader {
 public:
  explicit Reader(const vectors::PayloadCodec& codec)
      : codec_(codec), object_(codec.object_size), responses(codec.object_size) {}

  /// False when a digit has no value: the response is not added and counts as missing.
  bool add(const Given& given, std::uint64_t from) {
    packed_.assign(given.digits.size() / 2 + 1, 0);
    for (std::size_t i = 0; i < given.digits.size(); ++i) {
      const auto character = static_cast<std::uint8_t>(given.digits[given.digits.size() - 1 - i]);
      const std::uint8_t digit = vectors::detail::kDigitValues[character];
      if (digit == vectors::detail::kNoDigit) return false;
      packed_[i / 2] = static_cast<std::uint8_t>(packed_[i / 2] | (digit << (4 * (i % 2))));
    }
    if (!codec_.unpack(packed_.data(), object_.data())) return false;
    responses.add(object_.data(), static_cast<std::uint32_t>(given.cycle - from));
    return true;
  }

 private:
  const vectors::PayloadCodec& codec_;
  std::vector<std::byte> object_;
  std::vector<std::uint8_t> packed_;

 public:
  Responses responses;
};

/// Units without state: all cases were one stream.
void add_stream(const CaseTrace& trace, std::size_t cases, Reader& reader) {
  for (std::size_t i = 0; i < cases; ++i) {
    const std::uint64_t from = i < trace.accepted.size() ? trace.accepted[i] : 0;
    if (i < trace.given.size()) reader.add(trace.given[i], from);
    if (i + 1 == cases) {  // a surplus response is the last case's
      for (std::size_t j = i + 1; j < trace.given.size(); ++j) reader.add(trace.given[j], trace.given[j].cycle);
    }
    reader.responses.end_case(trace.hung && i >= trace.given.size());
  }
}

/// Units with state: latencies count from the first stimulus. What follows a response without a value is missing, too.
void add_episode(const CaseTrace& trace, Reader& reader) {
  const std::uint64_t from = trace.accepted.empty() ? 0 : trace.accepted[0];
  for (const Given& given : trace.given) {
    if (!reader.add(given, from)) break;
  }
  reader.responses.end_case(trace.hung);
}

/// The Verilog twins of fpga/gateware/, under Icarus Verilog.
class GatewareBackend final : public Backend {
 public:
  std::string name() const override { return "gateware"; }
  bool has(const vectors::UnitDescription& unit) const override { return has_twin(unit); }
  std::string why_unavailable() const override { return why_no_simulator(); }

  Responses run(const vectors::VectorSet& set, const RunOptions& options) const override {
    if (set.empty()) return Responses(set.response_codec().object_size);
    const std::string text = simulate_twin(set, options);
    const std::vector<CaseTrace> traces = parse_trace(text);
    Reader reader(set.response_codec());
    if (set.unit().stateful) {
      for (const CaseTrace& trace : traces) add_episode(trace, reader);
    } else if (!traces.empty()) {
      add_stream(traces[0], set.size(), reader);
    }
    for (const CaseTrace& trace : traces) reader.responses.cycles += trace.cycles;
    if (reader.responses.cases() != set.size()) {
      throw std::runtime_error(fmt::format("vvp: {} cases, want {}", reader.responses.cases(), set.size()));
    }
    return std::move(reader.responses);
  }
};

}  // namespace

std::unique_ptr<Backend> make_gateware_backend() { return std::make_unique<GatewareBackend>(); }

}  // namespace cbvh::testbench
