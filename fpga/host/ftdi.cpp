// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/ftdi.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cbvh::host {

namespace {

constexpr double kClock = 12e6;
constexpr double kGreatestError = 0.03;
constexpr std::uint32_t kGreatestEighths = 8 * 0x3FFF + 7;
/// The chip's code of a fraction in eighths.
constexpr std::array<std::uint32_t, 8> kFractionCodes = {0, 3, 2, 4, 1, 5, 6, 7};
constexpr std::uint32_t kFullClock = 0x20000;  ///< 12 MHz, not the 3 MHz of older chips

}  // namespace

std::optional<FtdiDivisor> ftdi_divisor(std::uint32_t baud) {
  if (baud == 0) return std::nullopt;
  const double wanted = 8 * kClock / baud;
  if (wanted > kGreatestEighths + 1) return std::nullopt;
  auto eighths = static_cast<std::uint32_t>(std::lround(wanted));
  std::uint32_t code = 0;
  if (eighths < 16) {  // below 2 there are but 1, written 0, and 1.5, written 1
    eighths = eighths < 10 ? 8 : eighths < 14 ? 12 : 16;
    code = eighths == 8 ? 0 : eighths == 12 ? 1 : 2;
  } else {
    eighths = std::min(eighths, kGreatestEighths);
    code = (eighths >> 3) | kFractionCodes[eighths & 7] << 14;
  }
  code |= kFullClock;
  const double found = 8 * kClock / eighths;
  if (std::abs(found - baud) > kGreatestError * baud) return std::nullopt;
  return FtdiDivisor{static_cast<std::uint16_t>(code & 0xFFFF), static_cast<std::uint8_t>(code >> 16), found};
}

Bytes ftdi_data(ByteSpan transfer, std::size_t packet_bytes) {
  Bytes data;
  data.reserve(transfer.size());
  while (!transfer.empty()) {
    const ByteSpan packet = transfer.first(std::min(packet_bytes, transfer.size()));
    transfer = transfer.subspan(packet.size());
    append(data, packet.subspan(std::min(kFtdiStatusBytes, packet.size())));
  }
  return data;
}

}  // namespace cbvh::host
