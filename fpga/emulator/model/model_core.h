// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <future>
#include <optional>
#include <string>
#include <variant>

#include "fpga/emulator/core.h"
#include "fpga/emulator/model/batch_runner.h"
#include "fpga/emulator/model/worker.h"
#include "fpga/host/frame_reader.h"
#include "fpga/host/messages.h"

namespace cbvh::emulator {

/// How large the buffers of a board are, and what is on it.
struct CoreOptions {
  std::uint16_t buffers = 4;                                   ///< batches
  std::uint32_t greatest_payload_in = std::uint32_t{1} << 20;  ///< bytes
  std::uint32_t greatest_payload_out = std::uint32_t{1} << 20;
  std::string unit = {};            ///< offer only this one; empty: all units
  std::optional<int> bits = {};     ///< offer only this N
  std::optional<int> treelet = {};  ///< offer only this D
};

/// The board's side of the link with the C++ modules inside, units of the rtl backend. Batches are computed on a thread
/// of their own as they come, and count when their RESULTS are sent; until then RESET makes them undone.
class ModelCore final : public Core {
 public:
  /// Throws InputError when there is no such unit, or not with this N and D.
  explicit ModelCore(const CoreOptions& options = {});

  void receive(std::span<const std::uint8_t> bytes) override;
  std::vector<std::uint8_t> send(std::size_t most) override;
  void reset() override;

 private:
  using Bytes = host::Bytes;
  using FrameType = host::FrameType;
  /// What a batch has given: the frame of RESULTS, but for its header, credit and checksum.
  struct ComputedBatch {
    Bytes frame;
    std::uint32_t cycles;
  };
  struct QueuedBatch {
    std::future<ComputedBatch> computed;
    std::uint32_t number;
    std::uint32_t sequence;
  };
  /// A frame to be sent, but for its credit; or what becomes one.
  using Answer = std::variant<host::BoardHello, host::OpenAnswer, host::BoardStatus, host::BoardError, QueuedBatch,
                              host::BoardCredit>;
  struct Queued {
    FrameType type;
    Answer answer;
  };

  void take(const host::FrameReader::Frame& frame);
  void take_whole(const host::Header& header, host::ByteSpan payload);
  void take_open(std::uint32_t sequence, host::ByteSpan payload);
  void take_vectors(std::uint32_t sequence, host::ByteSpan payload);
  void restart(std::uint32_t sequence);
  void forget();
  void refuse(std::uint32_t sequence, host::ErrorReason reason, std::uint32_t detail);
  void answer(FrameType type, Answer answer) { queue_.push_back({type, std::move(answer)}); }

  std::uint32_t credit() const;
  host::BoardStatus status() const;
  host::BoardHello hello() const;
  void send_next();
  void send_batch(QueuedBatch& batch);
  void append_frame(FrameType type, const Bytes& payload);

  const CoreOptions options_;
  BatchRunner runner_;                                 ///< its batches are the worker's
  const std::vector<vectors::UnitDescription> units_;  ///< on offer
  host::FrameReader reader_;
  host::FrameReader::Counters counted_before_;  ///< what the reader had counted at the last restart
  host::SequenceTracker sequence_;
  std::optional<OpenUnit> open_;
  std::deque<Queued> queue_;
  unsigned batches_queued_ = 0;
  Bytes sending_;
  std::size_t sent_ = 0;  ///< of sending_
  std::uint32_t next_sequence_ = 0;
  std::uint32_t taken_ = 0;
  std::uint32_t batches_ = 0;
  std::uint32_t cycles_ = 0;
  Worker<ComputedBatch> worker_;  ///< last: it ends before what it uses
};

}  // namespace cbvh::emulator
