// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/gateware/gateware_core.h"

#include <algorithm>

namespace cbvh::emulator {

namespace {

/// Of one request: about a tenth of a second.
constexpr unsigned kMostClocks = 20'000;
/// In one call of send, as long as nothing comes out.
constexpr unsigned kMostRequests = 10;

}  // namespace

void GatewareCore::receive(std::span<const std::uint8_t> bytes) { in_.insert(in_.end(), bytes.begin(), bytes.end()); }

void GatewareCore::advance() {
  const std::size_t count = queued_ ? 0 : std::min(in_.size(), Simulation::kMostBytes);
  const auto end = in_.begin() + static_cast<std::ptrdiff_t>(count);
  const std::vector<std::uint8_t> bytes(in_.begin(), end);
  in_.erase(in_.begin(), end);
  const auto answer = simulation_.run(bytes, kMostClocks);
  ended_ = !answer;
  if (ended_) return;
  out_.insert(out_.end(), answer->bytes.begin(), answer->bytes.end());
  queued_ = answer->left > 0;
  busy_ = answer->busy;
}

std::vector<std::uint8_t> GatewareCore::send(std::size_t most) {
  for (unsigned i = 0; i < kMostRequests && out_.empty() && !ended_ && (!in_.empty() || queued_ || busy_); ++i)
    advance();
  const auto end = out_.begin() + static_cast<std::ptrdiff_t>(std::min(most, out_.size()));
  std::vector<std::uint8_t> bytes(out_.begin(), end);
  out_.erase(out_.begin(), end);
  return bytes;
}

void GatewareCore::reset() {
  in_.clear();
  out_.clear();
  queued_ = busy_ = false;
  ended_ = ended_ || !simulation_.restart();
}

}  // namespace cbvh::emulator
