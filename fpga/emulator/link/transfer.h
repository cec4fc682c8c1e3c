// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

namespace cbvh::emulator {

using Clock = std::chrono::steady_clock;
using Time = Clock::time_point;

enum class Direction : std::uint8_t { out, in };  ///< as USB has it: out of the host, into the host

/// How a transfer of a bulk endpoint ends.
struct Transfer {
  enum class Status : std::uint8_t {
    done,
    pending,  ///< not now (NAK): the transfer stays where it is
    stalled,  ///< the endpoint is halted until clear_halt
    babbled   ///< the device sent more than was asked for: nothing of it arrives
  };
  Status status = Status::done;
  std::vector<std::uint8_t> bytes = {};  ///< of a transfer into the host
};

}  // namespace cbvh::emulator
