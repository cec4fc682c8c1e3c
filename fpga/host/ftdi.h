// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "fpga/host/bytes.h"

/// What FTDI's FT2232H and FT232H want of a host, apart from the USB transfers themselves.
namespace cbvh::host {

enum class FtdiRequest : std::uint8_t {
  reset = 0,
  modem_control = 1,
  flow_control = 2,
  baud_rate = 3,
  line = 4,
  latency = 9,
  bit_mode = 11
};
/// Values of FtdiRequest::reset.
constexpr std::uint16_t kFtdiResetAll = 0;
constexpr std::uint16_t kFtdiPurgeIn = 1;   ///< what the chip holds for the host
constexpr std::uint16_t kFtdiPurgeOut = 2;  ///< what it holds for the other side
constexpr std::uint16_t kFtdiLine8N1 = 8;
/// Modes, for the high byte of FtdiRequest::bit_mode's value; the low byte is a mask of outputs.
constexpr std::uint8_t kFtdiModeReset = 0x00;
constexpr std::uint8_t kFtdiModeSyncFifo = 0x40;
constexpr std::uint16_t kFtdiLatencyMs = 1;  ///< after which a packet is sent that is not full
constexpr std::size_t kFtdiStatusBytes = 2;  ///< in front of every packet into the host

/// The divisor of a baud rate: value and the high byte of index of FtdiRequest::baud_rate.
struct FtdiDivisor {
  std::uint16_t value = 0;
  std::uint8_t index_high = 0;
  double baud = 0;  ///< that it gives
};
/// Of the 12 MHz that divide by whole eighths from 2 on, and by 1 and 1.5. Nothing when the nearest rate is more than
/// 3 % off: then a UART loses bits.
std::optional<FtdiDivisor> ftdi_divisor(std::uint32_t baud);

/// The data of a transfer into the host: without the two status bytes of each of its packets.
Bytes ftdi_data(ByteSpan transfer, std::size_t packet_bytes);

}  // namespace cbvh::host
