// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/lockstep/episode.h"

#include <algorithm>
#include <string_view>

namespace cbvh::testbench {

namespace {

constexpr std::size_t kClocksAfterLastMove = 8;

/// Clocks before the push of an item that the log does not have.
std::size_t known_clocks(const ChannelLog& log) {
  std::size_t pushes = 0;
  for (std::size_t i = 0; i < log.clocks.size(); ++i) {
    if ((log.clocks[i] & ChannelLog::push) != 0 && pushes++ == log.items.size()) return i;
  }
  return log.clocks.size();
}

std::size_t moving_clocks(const ChannelLog& log) {
  std::size_t clocks = log.clocks.size();
  while (clocks > 0 && (log.clocks[clocks - 1] & (ChannelLog::push | ChannelLog::pop)) == 0) --clocks;
  return clocks;
}

}  // namespace

std::string packed_hex(const vectors::PayloadCodec& codec, const void* payload) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::vector<std::uint8_t> packed(codec.packed_bytes());
  codec.pack(payload, packed.data());
  std::string text;
  for (auto i = static_cast<std::size_t>(vectors::hex_digits(static_cast<int>(codec.width))); i-- > 0;) {
    text.push_back(kDigits[(packed[i / 2] >> (4 * (i % 2))) & 0xFU]);
  }
  return text;
}

void cut_episode(Episode& episode) {
  std::size_t moving = 0;
  std::size_t known = episode.channels.at(0).clocks.size();
  for (const ChannelLog& log : episode.channels) {
    moving = std::max(moving, moving_clocks(log));
    known = std::min(known, known_clocks(log));
  }
  for (ChannelLog& log : episode.channels) log.clocks.resize(std::min(moving + kClocksAfterLastMove, known));
}

}  // namespace cbvh::testbench
