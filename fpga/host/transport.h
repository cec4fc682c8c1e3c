// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "fpga/host/bytes.h"

namespace cbvh::host {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::milliseconds;

/// A stream of bytes to a board and one from it, with several transfers under way in both. Bytes may get lost or
/// changed; frames find out. One thread uses it. The destructor ends all transfers and gives the device back.
class Transport {
 public:
  Transport() = default;
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// The device, as errors name it: "usb 1:5 1209:b5c0 'cbvh board' serial 17".
  virtual std::string device() const = 0;

  /// Puts bytes on their way. Waits while too many are under way; false when that lasts longer than the timeout, and
  /// then these bytes are not sent. Throws LinkError when the device is gone.
  virtual bool send(Bytes bytes, Milliseconds timeout) = 0;
  /// The bytes that have come, as soon as there are any; none after the timeout. Throws LinkError when the device is
  /// gone or sends what it must not.
  virtual Bytes receive(Milliseconds timeout) = 0;
  /// Throws away what is under way in both directions, and brings halted endpoints back.
  virtual void restart() {}
  /// Opens a device that has gone again once it is back. False when it is not within the timeout.
  virtual bool reconnect(Milliseconds timeout) {
    static_cast<void>(timeout);
    return false;
  }
  /// The time by which timeouts count.
  virtual Clock::time_point now() const { return Clock::now(); }
};

}  // namespace cbvh::host
