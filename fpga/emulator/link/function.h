// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fpga/emulator/link/link.h"

namespace cbvh::emulator {

/// The ways over which a board is reached.
enum class Transport : std::uint8_t {
  bulk,       ///< a vendor-class device of our own
  ftdi_uart,  ///< FT2232H, a UART behind its second interface, as on the iCE40 HX8K breakout board
  ftdi_fifo   ///< FT232H, a parallel FIFO (245)
};

/// "bulk", "ftdi-uart" or "ftdi-fifo". Throws InputError("--transport") naming them.
Transport parse_transport(const std::string& text);
std::string to_string(Transport transport);

/// The eight bytes that begin a control transfer.
struct Setup {
  std::uint8_t request_type;
  std::uint8_t request;
  std::uint16_t value;
  std::uint16_t index;
  std::uint16_t length;
};

/// What a USB device does on its endpoints, above a link. One thread at a time.
class Function {
 public:
  Function() = default;
  virtual ~Function() = default;
  Function(const Function&) = delete;
  Function& operator=(const Function&) = delete;

  /// A vendor request; the bytes that answer it, or nothing: stalled.
  virtual std::optional<std::vector<std::uint8_t>> control(const Setup& setup) = 0;
  /// Transfers by endpoint address, 0x80 and more into the host.
  virtual Transfer out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes, Time now) = 0;
  virtual Transfer in(std::uint8_t endpoint, std::size_t most, Time now) = 0;
  virtual void clear_halt(std::uint8_t endpoint) = 0;
  /// When to try transfers that are pending again; nothing: when something has happened.
  virtual std::optional<Time> wake() const = 0;
  /// What power-on does to the function itself.
  virtual void power_on() = 0;
};

std::unique_ptr<Function> make_function(Transport transport, Link& link);

}  // namespace cbvh::emulator
