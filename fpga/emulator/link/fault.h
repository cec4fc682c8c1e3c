// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cbvh::emulator {

/// What goes wrong with a transfer of the link.
enum class FaultKind : std::uint8_t {
  stall,       ///< the endpoint halts; the transfer's bytes stay where they are
  nak,         ///< no answer for a while, which may be longer than the host waits
  short_,      ///< a transfer into the host ends early; the rest comes with the next
  babble,      ///< a transfer into the host is too long for its buffer: its bytes are lost
  corrupt,     ///< some bytes change
  drop,        ///< some bytes, or all of the transfer, are lost
  duplicate,   ///< the transfer's bytes arrive twice
  delay,       ///< the answer takes a few milliseconds
  reorder,     ///< the transfer's bytes arrive behind those of the next
  disconnect,  ///< the board is unplugged
  reconnect,   ///< the board is unplugged and plugged in again
  reset        ///< the board starts anew, as after power-on
};

inline constexpr std::array kFaultNames = {
    std::string_view("stall"),      std::string_view("nak"),       std::string_view("short"),
    std::string_view("babble"),     std::string_view("corrupt"),   std::string_view("drop"),
    std::string_view("duplicate"),  std::string_view("delay"),     std::string_view("reorder"),
    std::string_view("disconnect"), std::string_view("reconnect"), std::string_view("reset")};

constexpr std::string_view to_string(FaultKind kind) { return kFaultNames[static_cast<std::size_t>(kind)]; }

/// A kind of fault and how often it happens.
struct Fault {
  FaultKind kind;
  double rate;  ///< probability for each transfer, 0 to 1
};

/// 2 % of all transfers.
inline constexpr double kUsualRate = 0.02;

/// Reads "KIND" or "KIND:RATE". Throws InputError("--fault") naming the kinds, or the range of a rate.
Fault parse_fault(const std::string& text);

}  // namespace cbvh::emulator
