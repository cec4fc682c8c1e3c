// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fpga/emulator/core.h"
#include "fpga/host/frame_reader.h"
#include "fpga/host/messages.h"
#include "vectors/random.h"

namespace cbvh::testing {

/// A board that computes wrong: in every RESULTS one bit of one response is flipped, and the frame is sound.
class WrongCore final : public emulator::Core {
 public:
  WrongCore(emulator::Core& core, std::uint64_t seed) : core_(core), random_(seed) {}

  void receive(std::span<const std::uint8_t> bytes) override { core_.receive(bytes); }
  std::vector<std::uint8_t> send(std::size_t most) override {
    while (to_send_.empty()) {
      const auto bytes = core_.send(kPiece);
      if (bytes.empty()) return {};
      reader_.feed(bytes);
      while (const auto frame = reader_.next()) pass(*frame);
    }
    const auto cut = to_send_.begin() + static_cast<std::ptrdiff_t>(std::min(most, to_send_.size()));
    std::vector<std::uint8_t> bytes(to_send_.begin(), cut);
    to_send_.erase(to_send_.begin(), cut);
    return bytes;
  }
  void reset() override {
    core_.reset();
    reader_.clear();
    to_send_.clear();
  }

 private:
  static constexpr std::size_t kPiece = 65536;

  void pass(const host::FrameReader::Frame& frame) {
    host::Bytes payload(frame.payload.begin(), frame.payload.end());
    // The first episode's first response, behind the latency.
    constexpr std::size_t kFirst = host::BatchResults::kFixedBytes + host::BatchResults::kEpisodeBytes + 4;
    if (frame.header.type == host::FrameType::results && payload.size() > kFirst) {
      payload[kFirst] = static_cast<std::uint8_t>(payload[kFirst] ^ (1U << random_.below(2)));
    }
    host::append_frame(to_send_, frame.header.type, frame.header.sequence, payload);
  }

  emulator::Core& core_;
  vectors::Random random_;
  host::FrameReader reader_{std::size_t{1} << 24U};
  host::Bytes to_send_;
};

}  // namespace cbvh::testing
