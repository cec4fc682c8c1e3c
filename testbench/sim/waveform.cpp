// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/waveform.h"

#include <charconv>

namespace cbvh::testbench {

namespace {

std::uint64_t parse_cycle(std::string_view text, std::uint64_t otherwise) {
  if (text.empty()) return otherwise;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw golden::InputError("--cycles", fmt::format("found '{}', want a cycle number", text));
  return value;
}

}  // namespace

void parse_cycles(const std::string& text, WaveformRequest& request) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw golden::InputError("--cycles", fmt::format("found '{}', want FIRST:LAST", text));
  request.first_cycle = parse_cycle(std::string_view(text).substr(0, colon), 0);
  request.last_cycle = parse_cycle(std::string_view(text).substr(colon + 1), ~std::uint64_t{0});
  if (request.first_cycle > request.last_cycle) {
    throw golden::InputError("--cycles",
                             fmt::format("first {} is after last {}", request.first_cycle, request.last_cycle));
  }
}

}  // namespace cbvh::testbench
