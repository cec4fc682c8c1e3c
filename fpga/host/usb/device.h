// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libusb-1.0/libusb.h>

#include <memory>
#include <optional>
#include <vector>

#include "fpga/host/boards.h"

namespace cbvh::host {

struct UnrefDevice {
  void operator()(libusb_device* device) const { libusb_unref_device(device); }
};
struct CloseHandle {
  void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using UsbDevice = std::unique_ptr<libusb_device, UnrefDevice>;
using UsbHandle = std::unique_ptr<libusb_device_handle, CloseHandle>;

/// A device that may be a board.
struct FoundBoard {
  UsbDevice device;
  BoardInfo info;
};

/// Those with the product ids of boards; with a choice by product id or address, those that it names.
std::vector<FoundBoard> find_boards(libusb_context* context, const BoardChoice& choice);
/// The one that is meant. Throws LinkError: no_device, ambiguous, no_permission.
FoundBoard choose_board(libusb_context* context, const BoardChoice& choice);
/// Throws LinkError: no_permission, busy, gone.
UsbHandle open_device(const FoundBoard& board);
[[noreturn]] void fail_usb(const BoardInfo& board, int error, const char* action);

/// Where the bytes go.
struct Endpoints {
  int interface = 0;
  std::uint8_t in = 0;
  std::uint8_t out = 0;
  std::uint16_t in_packet = 512;  ///< bytes
};
/// The first vendor class interface, from `first_interface` on, with bulk endpoints in and out. Throws LinkError
/// (not_a_board).
Endpoints find_endpoints(const FoundBoard& board, int first_interface);

}  // namespace cbvh::host
