// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "fpga/host/frame.h"

namespace cbvh::host {

/// Finds frames in a stream of bytes, however it is cut. Bytes that belong to no frame are counted, never waited for.
class FrameReader {
 public:
  enum class Kind : std::uint8_t {
    whole,
    other_version,  ///< the header alone; what follows it is looked at for the next magic
    too_long        ///< likewise: its length is above the greatest payload
  };
  struct Frame {
    Kind kind;
    Header header;
    ByteSpan payload;  ///< good until the next call of a member that is not const
  };
  struct Counters {
    std::uint64_t skipped = 0;    ///< bytes outside of frames
    std::uint64_t corrupted = 0;  ///< frames whose payload had a wrong checksum
    bool operator==(const Counters&) const = default;
  };

  explicit FrameReader(std::size_t greatest_payload) : greatest_payload_(greatest_payload) {}

  void feed(ByteSpan bytes);
  /// The next frame, or nothing when more bytes are needed.
  std::optional<Frame> next();
  /// Whether a good header has come, and not yet all of its payload. Only after next() has given nothing.
  bool in_frame() const { return header_.has_value(); }
  /// Gives up a frame that has begun and not ended: the bytes behind its first are looked at again. For a receiver
  /// that has waited long enough for its end. False when there is none.
  bool give_up_unfinished();
  /// Forgets what has been fed and not been looked at.
  void clear();

  void set_greatest_payload(std::size_t bytes) { greatest_payload_ = bytes; }
  const Counters& counters() const { return counters_; }

 private:
  ByteSpan unread() const { return ByteSpan(buffer_).subspan(begin_); }
  void skip(std::size_t bytes);
  bool find_header();

  std::size_t greatest_payload_;
  Bytes buffer_;
  std::size_t begin_ = 0;         ///< in buffer_, of what has not been looked at
  std::optional<Header> header_;  ///< good, at begin_; its payload is not complete yet
  Counters counters_;
};

/// The sequence numbers of one direction, as their receiver sees them.
class SequenceTracker {
 public:
  /// False for a frame that is behind: to be dropped. Numbers jumped over are lost.
  bool take(std::uint32_t sequence) {
    const std::uint32_t ahead = sequence - next_;
    if (static_cast<std::int32_t>(ahead) < 0) {
      ++stale_;
      return false;
    }
    lost_ += ahead;
    next_ = sequence + 1;
    return true;
  }
  /// A frame that is taken whatever its number.
  void restart(std::uint32_t sequence) { next_ = sequence + 1; }

  std::uint32_t next() const { return next_; }
  std::uint64_t lost() const { return lost_; }
  std::uint64_t stale() const { return stale_; }

 private:
  std::uint32_t next_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t stale_ = 0;
};

}  // namespace cbvh::host
