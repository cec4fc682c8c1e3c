// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "fpga/emulator/core.h"
#include "fpga/host/frame_reader.h"
#include "fpga/host/messages.h"
#include "vectors/registry.h"

namespace cbvh::testing {

struct ReceivedFrame {
  host::Header header;
  host::Bytes payload;
};

inline host::Bytes open_payload(std::string_view unit, int bits, int treelet) {
  return host::OpenRequest{host::unit_id(unit), static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(treelet)}
      .to_payload();
}

/// Sends frames to a core and reads its answers.
class Talk {
 public:
  explicit Talk(emulator::Core& core) : core_(core) {}

  void send(host::FrameType type, host::ByteSpan payload = {}) {
    host::Bytes bytes;
    host::append_frame(bytes, type, sequence++, payload);
    core_.receive(bytes);
  }
  /// The payload of BOARD_OPEN; an empty one when that fails.
  host::Bytes open(std::string_view unit, int bits = 6, int treelet = 1) {
    send(host::FrameType::open, open_payload(unit, bits, treelet));
    return receive_one(host::FrameType::board_open);
  }
  void send_raw(host::ByteSpan bytes) { core_.receive(bytes); }

  /// All frames that the core has, taken from it `piece` bytes at a time.
  std::vector<ReceivedFrame> receive(std::size_t piece = 4096) {
    for (auto bytes = core_.send(piece); !bytes.empty(); bytes = core_.send(piece)) {
      EXPECT_LE(bytes.size(), piece);
      reader_.feed(bytes);
    }
    std::vector<ReceivedFrame> frames;
    while (const auto frame = reader_.next()) {
      EXPECT_EQ(frame->kind, host::FrameReader::Kind::whole);
      frames.push_back({frame->header, {frame->payload.begin(), frame->payload.end()}});
    }
    EXPECT_EQ(reader_.counters(), host::FrameReader::Counters());
    return frames;
  }

  /// The one frame that the core has, of the type given; an empty payload when that fails.
  host::Bytes receive_one(host::FrameType type) {
    const auto frames = receive();
    EXPECT_EQ(frames.size(), 1U);
    if (frames.size() != 1) return {};
    EXPECT_EQ(host::to_string(frames[0].header.type), host::to_string(type));
    return frames[0].header.type == type ? frames[0].payload : host::Bytes();
  }
  void expect_error(host::ErrorReason reason, std::uint32_t of_sequence, std::uint32_t detail) {
    const auto error = host::BoardError::parse(receive_one(host::FrameType::error));
    ASSERT_TRUE(error);
    EXPECT_EQ(static_cast<int>(error->reason), static_cast<int>(reason));
    EXPECT_EQ(error->sequence, of_sequence);
    EXPECT_EQ(error->detail, detail);
  }

  std::uint32_t sequence = 0;

 private:
  emulator::Core& core_;
  host::FrameReader reader_{std::size_t{1} << 24U};
};

/// A batch of all cases of a set: one episode of a unit without state, one a case of others. Keeps the packed stimuli.
struct PackedBatch {
  explicit PackedBatch(const vectors::VectorSet& set, std::uint32_t number = 0) {
    batch.number = number;
    batch.hang_cycles = 20000;
    batch.drain_cycles = 64;
    const auto& codec = set.stimulus_codec();
    const auto add = [&](std::size_t begin, std::size_t size, std::size_t wanted) {
      host::Bytes& bytes = packed.emplace_back(size * codec.packed_bytes());
      for (std::size_t i = 0; i < size; ++i)
        codec.pack(set.stimulus_at(begin + i), bytes.data() + i * codec.packed_bytes());
      batch.episodes.push_back({static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(wanted), bytes});
    };
    if (!set.unit().stateful) add(0, set.stimulus_count(), set.response_count());
    for (std::size_t i = 0; set.unit().stateful && i < set.size(); ++i) {
      add(set.stimulus_range(i).begin, set.stimulus_range(i).size, set.response_range(i).size);
    }
  }

  host::Batch batch;
  std::vector<host::Bytes> packed;
};

}  // namespace cbvh::testing
