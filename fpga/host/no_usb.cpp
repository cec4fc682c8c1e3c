// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Instead of usb/, where there is no libusb.
#include "fpga/host/boards.h"
#include "fpga/host/link_error.h"

namespace cbvh::host {

std::string why_no_usb() { return "cbvh was built without libusb (Debian packages libusb-1.0-0-dev and pkg-config)"; }

std::vector<BoardInfo> list_boards() { return {}; }

std::unique_ptr<Transport> open_board(const BoardChoice&, const OpenOptions&) {
  throw LinkError(LinkFault::no_device, "board", why_no_usb());
}

}  // namespace cbvh::host
