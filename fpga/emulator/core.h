// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cbvh::emulator {

/// The inside of a board: the board's side of docs/board_protocol.md as two streams of bytes, cut anywhere. Whatever
/// the bytes are, a core neither throws nor blocks for long; it answers as the protocol says. One thread at a time.
class Core {
 public:
  Core() = default;
  virtual ~Core() = default;
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  /// Bytes from the host, in order.
  virtual void receive(std::span<const std::uint8_t> bytes) = 0;
  /// The next bytes for the host, at most so many; empty: there are none now.
  virtual std::vector<std::uint8_t> send(std::size_t most) = 0;
  /// Power-on: nothing queued, sequences from 0, counters 0, no unit open. Bytes not yet sent are lost.
  virtual void reset() = 0;
};

}  // namespace cbvh::emulator
