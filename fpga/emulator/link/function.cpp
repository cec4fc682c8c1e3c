// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/function.h"

#include <fmt/format.h>

#include "fpga/emulator/link/bulk_function.h"
#include "fpga/emulator/link/ftdi_function.h"
#include "golden/input_error.h"

namespace cbvh::emulator {

namespace {
constexpr const char* kTransportNames[] = {"bulk", "ftdi-uart", "ftdi-fifo"};
constexpr std::uint8_t kFirstChannel = 0;
constexpr std::uint8_t kSecondChannel = 1;
}  // namespace

std::string to_string(Transport transport) { return kTransportNames[static_cast<std::size_t>(transport)]; }

Transport parse_transport(const std::string& text) {
  for (const Transport transport : {Transport::bulk, Transport::ftdi_uart, Transport::ftdi_fifo}) {
    if (text == to_string(transport)) return transport;
  }
  throw golden::InputError("--transport", fmt::format("found '{}', want {}", text, fmt::join(kTransportNames, ", ")));
}

std::unique_ptr<Function> make_function(Transport transport, Link& link) {
  if (transport == Transport::bulk) return std::make_unique<BulkFunction>(link);
  return std::make_unique<FtdiFunction>(link, transport == Transport::ftdi_uart ? kSecondChannel : kFirstChannel);
}

}  // namespace cbvh::emulator
