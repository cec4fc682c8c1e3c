// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "fpga/host/frame_reader.h"
#include "fpga/host/link_error.h"
#include "fpga/host/messages.h"
#include "fpga/host/transport.h"

namespace cbvh::host {

/// What has passed over a link since it was made.
struct LinkCounters {
  std::uint64_t frames_sent = 0;
  std::uint64_t bytes_sent = 0;  ///< of frames
  std::uint64_t frames_received = 0;
  std::uint64_t bytes_received = 0;  ///< of frames
  std::uint64_t skipped = 0;         ///< bytes of the board outside of frames
  std::uint64_t corrupted = 0;       ///< frames of the board
  std::uint64_t lost = 0;
  std::uint64_t stale = 0;
};

/// Frames over a transport: numbers them, checks those of the board, and keeps its credit.
class Link {
 public:
  /// The link does not own the transport.
  Link(Transport& transport, Milliseconds timeout) : transport_(transport), timeout_(timeout) {}

  /// Returns the frame's sequence. A frame that the transport does not take in time is as good as lost.
  std::uint32_t send(FrameType type, ByteSpan payload = {});
  /// The same of a frame for which there is room of kHeaderBytes in front, and none behind.
  std::uint32_t send_in_place(FrameType type, Bytes frame);
  void send_zeros(std::size_t bytes);

  struct Frame {
    FrameType type;
    std::uint32_t sequence;
    ByteSpan payload;  ///< good until the next call
  };
  /// The board's next frame that is not behind; nothing when none has come until `deadline`. As long as the bytes of
  /// one keep coming, it waits on, up to ten timeouts. Throws LinkError for a frame of another version.
  std::optional<Frame> receive(Clock::time_point deadline);
  /// The board's numbers go on from this frame.
  void restart_sequence(std::uint32_t sequence) { tracker_.restart(sequence); }
  /// From now on frames are taken whatever their sequence, or not.
  void take_any_sequence(bool any) { any_sequence_ = any; }
  void forget_received() { reader_.clear(); }
  void set_greatest_payload(std::size_t bytes) { reader_.set_greatest_payload(bytes); }

  std::uint32_t next_sequence() const { return next_sequence_; }  ///< of the next frame sent
  /// Whether the board would now take VECTORS.
  bool has_credit() const { return static_cast<std::int32_t>(credit_ - next_sequence_) > 0; }

  Transport& transport() { return transport_; }
  Clock::time_point deadline() const { return transport_.now() + timeout_; }
  Milliseconds timeout() const { return timeout_; }
  bool has_gap() { return std::exchange(gap_, false); }  ///< since the last call frames of the board were lost
  LinkCounters counters() const;
  [[noreturn]] void fail(LinkFault fault, const std::string& what) const;

 private:
  std::optional<Frame> take(const FrameReader::Frame& frame);

  static constexpr std::size_t kGreatestPayloadAtFirst = std::size_t{1} << 20;

  Transport& transport_;
  Milliseconds timeout_;
  FrameReader reader_{kGreatestPayloadAtFirst};
  SequenceTracker tracker_;
  bool any_sequence_ = true;
  bool gap_ = false;
  std::uint32_t next_sequence_ = 0;
  std::uint32_t credit_ = 0;
  LinkCounters counters_;
};

}  // namespace cbvh::host
