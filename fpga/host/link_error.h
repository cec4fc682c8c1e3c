// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "golden/input_error.h"

namespace cbvh::host {

/// What can be wrong between a host and its board.
enum class LinkFault : std::uint8_t {
  no_device,  ///< none is there, or none that fits the choice
  ambiguous,  ///< several are
  no_permission,
  busy,         ///< another program has it
  not_a_board,  ///< its descriptors are not those of a board
  protocol_version,
  firmware_version,
  unknown_unit,
  parameters,  ///< the unit is not there with this N or D, or has payloads of other widths
  too_large,   ///< a case does not fit the board's buffers
  gone,        ///< unplugged, and not back in time
  timeout,     ///< no answer, whatever was tried
  overflow,    ///< it sent more than was asked for
  refused,     ///< it answered with an error that sending again does not cure
};

/// Whether connecting again, or a reset, may cure it.
constexpr bool may_pass(LinkFault fault) {
  return fault == LinkFault::gone || fault == LinkFault::timeout || fault == LinkFault::overflow;
}

/// Its place is the device. The message says what is wrong and what to do.
class LinkError : public golden::InputError {
 public:
  LinkError(LinkFault fault, std::string device, const std::string& what)
      : InputError(std::move(device), what), fault_(fault), message_(what) {}

  LinkFault fault() const { return fault_; }
  const std::string& message() const { return message_; }  ///< without the place

 private:
  LinkFault fault_;
  std::string message_;
};

}  // namespace cbvh::host
