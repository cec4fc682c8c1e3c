// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fpga/host/transport.h"

/// The boards on this machine's USB, and the transports to them.
namespace cbvh::host {

/// Which board is meant: "usb:VVVV:PPPP" (hexadecimal), "serial=TEXT", "BUS:ADDRESS" (decimal), or empty: the only one.
struct BoardChoice {
  /// Throws InputError, whose place is `option`.
  static BoardChoice parse(const std::string& option, const std::string& text);

  std::string text;  ///< as it was given
  enum class By : std::uint8_t { only_one, product_id, serial, address } by = By::only_one;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string serial;
  std::uint8_t bus = 0;
  std::uint8_t address = 0;
};

enum class BoardKind : std::uint8_t {
  bulk,       ///< a vendor class interface with a bulk endpoint in each direction
  ftdi_uart,  ///< FT2232H, its second channel
  ftdi_fifo   ///< FT232H, 245 synchronous FIFO
};
std::string to_string(BoardKind kind);

struct BoardInfo {
  BoardKind kind = BoardKind::bulk;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint8_t bus = 0;
  std::uint8_t address = 0;
  std::string product_name;  ///< empty when it cannot be read
  std::string serial;
  std::string speed;    ///< "high (480 Mbit/s)", ...
  std::string problem;  ///< empty, or why it cannot be opened
  /// Its product name begins with "cbvh", so that it is taken without being named.
  bool ours() const { return std::string_view(product_name).starts_with("cbvh"); }
  /// "usb 1:5 1209:b5c0 'cbvh board' serial 17"
  std::string device() const;
};

struct OpenOptions {
  std::uint32_t baud = 3000000;  ///< of a UART
  Milliseconds wait{0};          ///< for a board to be plugged in
};

/// Empty, or why no board can be reached from this program.
std::string why_no_usb();

/// Devices that may be boards.
std::vector<BoardInfo> list_boards();

/// Throws LinkError: no_device, ambiguous, no_permission, busy, not_a_board.
std::unique_ptr<Transport> open_board(const BoardChoice& choice, const OpenOptions& options = {});

}  // namespace cbvh::host
