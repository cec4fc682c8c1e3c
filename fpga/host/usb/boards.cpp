// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/boards.h"

#include "fpga/host/link_error.h"
#include "fpga/host/usb/transport.h"

namespace cbvh::host {

std::string why_no_usb() { return {}; }

std::vector<BoardInfo> list_boards() {
  const UsbContext context;
  std::vector<BoardInfo> boards;
  for (const FoundBoard& board : find_boards(context.get(), {})) boards.push_back(board.info);
  return boards;
}

std::unique_ptr<Transport> open_board(const BoardChoice& choice, const OpenOptions& options) {
  auto context = std::make_shared<UsbContext>();
  const Clock::time_point end = Clock::now() + options.wait;
  for (std::uint64_t changes = 0;;) {
    try {
      FoundBoard found = choose_board(context->get(), choice);
      std::unique_ptr<UsbTransport> transport;
      if (found.info.kind == BoardKind::bulk) {
        transport = std::make_unique<UsbTransport>(context, found.info);
      } else {
        transport = std::make_unique<FtdiTransport>(context, found.info, options.baud);
      }
      transport->connect(std::move(found));
      return transport;
    } catch (const LinkError& error) {
      if (error.fault() != LinkFault::no_device || Clock::now() >= end) throw;
    }
    changes = context->wait_for_change(changes, Milliseconds(200));
  }
}

}  // namespace cbvh::host
