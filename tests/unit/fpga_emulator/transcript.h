// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fpga/emulator/model/model_core.h"
#include "talk.h"
#include "testbench/gateware/simulator.h"
#include "vectors/random.h"

/// Conversations with a board of two batch buffers of 4 KiB and one unit, for comparing two cores.
namespace cbvh::testing {

inline constexpr std::size_t kBufferBytes = 4096;
inline constexpr std::size_t kHelloBoard = 24;  ///< bytes of HELLO before its name
inline constexpr std::size_t kHelloClock = 8;
inline constexpr std::size_t kResultsCycles = 8;

inline emulator::ModelCore model_core(const std::string& unit, int bits, int treelet = 1) {
  return emulator::ModelCore({.buffers = 2,
                              .greatest_payload_in = kBufferBytes,
                              .greatest_payload_out = kBufferBytes,
                              .unit = unit,
                              .bits = bits,
                              .treelet = treelet});
}

/// A conversation, turn by turn: all answers of a turn are awaited. Of HELLO the clock and the board's name are masked;
/// of a unit in a harness, which takes cycles of its own to tell what is in memory, the cycles run and latencies that
/// are not stated.
class Transcript {
 public:
  explicit Transcript(emulator::Core& core, const vectors::VectorSet* in_harness = nullptr)
      : core_(core), in_harness_(in_harness) {}

  void turn(host::ByteSpan bytes) {
    core_.receive(bytes);
    host::Bytes answers;
    for (auto more = core_.send(1000); !more.empty(); more = core_.send(1000)) host::append(answers, more);
    host::FrameReader reader(2 * kBufferBytes);
    reader.feed(answers);
    host::Bytes known;
    while (const auto frame = reader.next()) {
      host::Bytes payload(frame->payload.begin(), frame->payload.end());
      if (frame->header.type == host::FrameType::board_hello && payload.size() > kHelloBoard + host::kNameBytes) {
        std::fill_n(payload.begin() + kHelloClock, 4, std::uint8_t{0});
        std::fill_n(payload.begin() + kHelloBoard, host::kNameBytes, std::uint8_t{0});
      }
      if (in_harness_ != nullptr && frame->header.type == host::FrameType::results) mask_results(payload);
      if (in_harness_ != nullptr && frame->header.type == host::FrameType::board_status)
        std::fill_n(payload.end() - 4, 4, std::uint8_t{0});
      host::append_frame(known, frame->header.type, frame->header.sequence, payload);
      ++frames;
    }
    skipped += reader.counters().skipped + reader.counters().corrupted;
    turns.push_back(known);
  }
  void frame(host::FrameType type, host::ByteSpan payload = {}) {
    host::Bytes bytes;
    host::append_frame(bytes, type, sequence++, payload);
    turn(bytes);
  }
  bool operator==(const Transcript& other) const { return turns == other.turns && skipped == other.skipped; }

  std::vector<host::Bytes> turns;
  std::size_t frames = 0;
  std::uint64_t skipped = 0;
  std::uint32_t sequence = 0;
  std::size_t case_index = 0;  ///< in the set of a unit in a harness: what each episode of the next RESULTS is of

 private:
  void mask_results(host::Bytes& payload) const {
    std::fill_n(payload.begin() + kResultsCycles, 4, std::uint8_t{0});
    const std::size_t packed = in_harness_->response_codec().packed_bytes();
    const auto results = host::BatchResults::parse(payload, packed);
    ASSERT_TRUE(results);
    std::size_t at = host::BatchResults::kFixedBytes;
    for (const auto& episode : results->episodes) {
      at += host::BatchResults::kEpisodeBytes;
      const auto range = in_harness_->response_range(case_index);
      for (std::size_t i = 0; i < episode.responses; ++i, at += 4 + packed) {
        if (i < range.size && in_harness_->latency_at(range.begin + i) != vectors::kLatencyNotStated) continue;
        std::fill_n(payload.begin() + static_cast<std::ptrdiff_t>(at), 4, std::uint8_t{0});
      }
    }
  }

  emulator::Core& core_;
  const vectors::VectorSet* in_harness_;
};

/// Sets of cases, in batches that fit the buffers.
inline Transcript run_vectors(emulator::Core& core, const std::string& unit, int bits, std::uint64_t cases,
                              int treelet = 1) {
  const auto set = vectors::generate_set(unit, {bits, treelet}, cases, 5);
  Transcript talk(core, testbench::has_harness(set->unit()) ? set.get() : nullptr);
  talk.frame(host::FrameType::hello);
  talk.frame(host::FrameType::open, open_payload(unit, bits, treelet));
  PackedBatch all(*set, 7);
  const std::size_t stimulus = set->stimulus_codec().packed_bytes();
  const std::size_t record = 4 + set->response_codec().packed_bytes();
  const auto most = static_cast<std::uint32_t>((kBufferBytes - 100) / std::max(stimulus, record));
  for (const host::Batch::Episode& episode : all.batch.episodes) {
    host::Batch part = all.batch;
    if (set->unit().stateful) {
      talk.case_index = static_cast<std::size_t>(&episode - all.batch.episodes.data());
      part.episodes = {episode, episode};  // the second begins from reset as the first did
      part.episodes.resize(episode.stimuli <= most / 2 ? 2 : 1);
      if (episode.stimuli <= most && episode.wanted <= most) talk.frame(host::FrameType::vectors, part.to_payload());
      continue;
    }
    for (std::uint32_t begin = 0; begin < episode.stimuli; begin += most, ++part.number) {
      const std::uint32_t size = std::min(most, episode.stimuli - begin);
      part.episodes = {{size, size, episode.packed.subspan(begin * stimulus, size * stimulus)}};
      part.drain_cycles = static_cast<std::uint16_t>(3 * part.number);
      talk.frame(host::FrameType::vectors, part.to_payload());
    }
  }
  talk.frame(host::FrameType::status);
  return talk;
}

/// Every reason of an error, counters, reset, credit.
inline Transcript run_errors(emulator::Core& core) {
  const auto set = vectors::generate_set("axis_compressor", {6, 1}, 300, 9);
  const std::size_t stimulus = set->stimulus_codec().packed_bytes();
  PackedBatch packed(*set);
  const auto batch = [&](std::uint32_t stimuli, std::uint32_t wanted) {
    host::Batch part = packed.batch;
    part.episodes = {{stimuli, wanted, host::ByteSpan(packed.packed[0]).first(stimuli * stimulus)}};
    return part;
  };
  const host::Bytes good = batch(5, 5).to_payload();
  Transcript talk(core);
  talk.frame(host::FrameType::vectors, good);  // no unit is open
  talk.frame(host::FrameType::open, open_payload("axis_compressor", 6, 1));
  talk.frame(host::FrameType::open, open_payload("no_such_unit", 6, 1));
  talk.frame(host::FrameType::vectors, good);
  for (const auto& [bits, treelet] : {std::pair(5, 1), std::pair(22, 1), std::pair(6, 2), std::pair(6, 17)}) {
    talk.frame(host::FrameType::open, open_payload("axis_compressor", bits, treelet));
  }
  for (const std::size_t size : {1U, 7U, 9U, 300U}) talk.frame(host::FrameType::open, host::Bytes(size, 6));
  talk.frame(host::FrameType::open, open_payload("axis_compressor", 6, 1));
  talk.frame(static_cast<host::FrameType>(0x42));
  talk.frame(host::FrameType::results, host::Bytes(9));
  for (const host::FrameType type : {host::FrameType::hello, host::FrameType::status, host::FrameType::reset})
    talk.frame(type, host::Bytes(1));
  host::Bytes other;
  host::append_header(other, {2, host::FrameType::hello, 17, 0});
  talk.turn(other);
  host::Bytes foreign;  // a right checksum, but not our magic: its bytes are skipped
  host::append_header(foreign, {host::kProtocolVersion, host::FrameType::hello, talk.sequence, 0});
  foreign.resize(host::kHeaderBytes - sizeof(std::uint32_t));
  foreign[0] = static_cast<std::uint8_t>(foreign[0] ^ 1U);
  host::append(foreign, host::crc32c(foreign));
  host::Bytes several;  // so that bytes come late behind one of them
  for (int i = 0; i < 16; ++i) host::append(several, foreign);
  talk.turn(several);
  talk.frame(host::FrameType::status);
  talk.frame(host::FrameType::vectors, host::Bytes(kBufferBytes + 1, 3));  // its bytes are looked at for frames
  talk.frame(host::FrameType::status);
  for (const std::size_t size : {1U, 11U, 13U, 19U, 20U, 21U, 64U}) {
    host::Bytes cut = good;
    cut.resize(size);
    talk.frame(host::FrameType::vectors, cut);
  }
  talk.frame(host::FrameType::vectors);
  host::Bytes longer = good;
  longer.push_back(0);
  talk.frame(host::FrameType::vectors, longer);
  talk.frame(host::FrameType::vectors, batch(50, 215).to_payload());  // one response more than fits
  talk.frame(host::FrameType::vectors, batch(50, 70000).to_payload());
  host::Batch empty = packed.batch;
  empty.episodes.clear();
  talk.frame(host::FrameType::vectors, empty.to_payload());
  empty.episodes.push_back({});
  talk.frame(host::FrameType::vectors, empty.to_payload());
  talk.frame(host::FrameType::status);
  talk.sequence += 3;  // lost
  talk.frame(host::FrameType::status);
  talk.sequence -= 2;  // doubled
  talk.frame(host::FrameType::status);
  talk.frame(host::FrameType::status);
  host::Bytes corrupted;
  host::append_frame(corrupted, host::FrameType::vectors, talk.sequence, good);
  corrupted[60] ^= 0x10;
  talk.turn(corrupted);
  talk.frame(host::FrameType::vectors, good);
  talk.frame(host::FrameType::status);
  talk.sequence = 0xFFFFFFFF;
  talk.frame(host::FrameType::reset);
  talk.frame(host::FrameType::status);  // sequence 0
  talk.frame(host::FrameType::vectors, good);
  return talk;
}

/// Frames with bits turned, bytes lost and doubled, and bytes that are no frame.
inline Transcript run_noise(emulator::Core& core, std::uint64_t seed) {
  vectors::Random random(seed);
  Transcript talk(core);
  for (unsigned i = 0; i < 300; ++i) {
    host::Bytes bytes;
    for (std::uint64_t n = random.below(4); n > 0; --n) host::append(bytes, std::uint8_t{host::kMagic[n % 2]});
    const host::FrameType types[] = {host::FrameType::status, host::FrameType::open, host::FrameType::reset,
                                     static_cast<host::FrameType>(9)};
    const std::uint64_t kind = random.below(16);
    const host::FrameType type = types[kind < 8 ? 0 : kind < 13 ? 1 : kind < 14 ? 2 : 3];
    const host::Bytes payload =
        type == host::FrameType::open ? open_payload("axis_compressor", 6, 1) : host::Bytes(random.below(2) * 5);
    host::append_frame(bytes, type, talk.sequence++, payload);
    const std::size_t at = random.below(bytes.size());
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << random.below(8)));
        break;
      case 1:
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      case 2:
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes[at]);
        break;
      default:
        break;
    }
    talk.turn(bytes);
  }
  talk.turn(host::Bytes(kBufferBytes + 20));
  talk.frame(host::FrameType::status);
  return talk;
}

}  // namespace cbvh::testing
