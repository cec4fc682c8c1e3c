// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/ftdi.h"

#include "fpga/host/link_error.h"
#include "fpga/host/usb/transport.h"

namespace cbvh::host {

namespace {
constexpr unsigned kControlTimeoutMs = 1000;
}

void FtdiTransport::request(std::uint8_t request, std::uint16_t value, std::uint8_t index_high) {
  constexpr std::uint8_t kVendorOut = 0x40;
  const auto index = static_cast<std::uint16_t>(index_high << 8 | (endpoints().interface + 1));
  const int error =
      libusb_control_transfer(stream().handle(), kVendorOut, request, value, index, nullptr, 0, kControlTimeoutMs);
  if (error < 0) fail_usb(board(), error, "the FTDI chip refuses a request");
}

void FtdiTransport::configure() {
  const auto code = [](FtdiRequest request) { return static_cast<std::uint8_t>(request); };
  const auto mode = [](std::uint8_t bit_mode) { return static_cast<std::uint16_t>(bit_mode << 8 | 0xFF); };
  request(code(FtdiRequest::reset), kFtdiResetAll);
  request(code(FtdiRequest::latency), kFtdiLatencyMs);
  request(code(FtdiRequest::bit_mode), mode(kFtdiModeReset));
  request(code(FtdiRequest::flow_control), 0);
  if (board().kind == BoardKind::ftdi_fifo) {
    request(code(FtdiRequest::bit_mode), mode(kFtdiModeSyncFifo));
  } else {
    const auto divisor = ftdi_divisor(baud_);
    if (!divisor) {
      throw LinkError(LinkFault::parameters, device(), fmt::format("the chip cannot make {} baud within 3 %", baud_));
    }
    request(code(FtdiRequest::line), kFtdiLine8N1);
    request(code(FtdiRequest::baud_rate), divisor->value, divisor->index_high);
  }
  purge();
}

void FtdiTransport::purge() {
  request(static_cast<std::uint8_t>(FtdiRequest::reset), kFtdiPurgeIn);
  request(static_cast<std::uint8_t>(FtdiRequest::reset), kFtdiPurgeOut);
}

Bytes FtdiTransport::data_of(Bytes transfer) const { return ftdi_data(transfer, endpoints().in_packet); }

}  // namespace cbvh::host
