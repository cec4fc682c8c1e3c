// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fpga/emulator/core.h"
#include "fpga/emulator/link/fault.h"
#include "fpga/emulator/link/transfer.h"
#include "vectors/random.h"

namespace cbvh::emulator {

/// What the link wants done with the board's plug.
enum class Plug : std::uint8_t { stays, leaves, leaves_and_returns };

/// The pair of bulk endpoints in front of a core, and what goes wrong there. Which transfer has which fault depends
/// only on the seed and on the transfer's number in its direction. One thread at a time.
class Link {
 public:
  Link(Core& core, std::vector<Fault> faults, std::uint64_t seed);

  /// Bytes of the host for the core. When pending, the caller offers them again later.
  Transfer out(std::span<const std::uint8_t> bytes, Time now);
  /// Bytes of the core for the host, at most so many; pending: there are none now.
  Transfer in(std::size_t most, Time now);
  void clear_halt(Direction direction) { halted_[index(direction)] = false; }

  /// When to call again although nothing new has come from the host; nothing: no need to.
  std::optional<Time> wake() const;
  /// What has become of the plug; told once.
  Plug plug() { return std::exchange(plug_, Plug::stays); }
  /// The board is plugged in: everything starts anew, but the sequence of faults goes on.
  void power_on();

  /// Faults that have happened, by kind.
  const std::map<FaultKind, std::uint64_t>& happened() const { return happened_; }

 private:
  struct Held {
    std::vector<std::uint8_t> bytes;
    Time until;
  };

  static constexpr std::size_t index(Direction direction) { return static_cast<std::size_t>(direction); }
  std::optional<FaultKind> draw(Direction direction);
  /// True: nothing moves in this direction now.
  bool waits(Direction direction, Time now);
  /// Faults that keep the transfer from happening now; nothing for all others.
  std::optional<Transfer> interrupt(FaultKind kind, Direction direction, Time now);
  void deliver(std::span<const std::uint8_t> bytes);
  void release_out(Time now);
  /// What `kind` makes of a piece of the stream: zero, one or more pieces.
  std::vector<std::vector<std::uint8_t>> mangle(FaultKind kind, std::vector<std::uint8_t> bytes);
  std::vector<std::uint8_t> next_in(std::size_t most, Time now);
  void put_back(std::span<const std::uint8_t> bytes);
  Core& core_;
  std::vector<Fault> faults_;
  vectors::Random random_;
  std::array<std::uint64_t, 2> transfers_{};
  std::uint64_t seed_;
  std::array<bool, 2> halted_{};
  std::array<std::optional<Time>, 2> waits_until_;
  std::array<bool, 2> excused_{};  ///< it has waited: no fault for the same transfer again
  std::array<std::optional<Held>, 2> held_;
  std::deque<std::vector<std::uint8_t>> in_queue_;  ///< before what the core has
  Plug plug_ = Plug::stays;
  std::map<FaultKind, std::uint64_t> happened_;
};

}  // namespace cbvh::emulator
