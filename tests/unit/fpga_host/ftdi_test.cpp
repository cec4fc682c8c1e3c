// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/ftdi.h"

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace cbvh::host;

/// What the chip makes of a divisor: 12 MHz over whole and eighths.
double baud_of(const FtdiDivisor& divisor) {
  constexpr double kEighths[] = {0, 4, 2, 1, 3, 5, 6, 7};
  EXPECT_EQ(divisor.index_high & 0xFE, 2) << "not the 12 MHz clock";
  const int whole = divisor.value & 0x3FFF;
  const int code = divisor.value >> 14 | (divisor.index_high & 1) << 2;
  if (whole < 2) return whole == 0 ? 12e6 : 8e6;
  return 12e6 / (whole + kEighths[code] / 8);
}

TEST(FtdiDivisor, gives_every_usual_rate_within_three_per_cent) {
  for (const std::uint32_t baud : {1200u, 9600u, 115200u, 230400u, 460800u, 921600u, 1000000u, 1500000u, 2000000u,
                                   3000000u, 4000000u, 6000000u, 8000000u, 12000000u}) {
    const auto divisor = ftdi_divisor(baud);
    ASSERT_TRUE(divisor) << baud;
    EXPECT_NEAR(divisor->baud, baud, 0.03 * baud);
    EXPECT_DOUBLE_EQ(baud_of(*divisor), divisor->baud) << baud;
  }
  EXPECT_EQ(ftdi_divisor(3000000)->value, 4);
  EXPECT_EQ(ftdi_divisor(3000000)->index_high, 2);
  EXPECT_EQ(ftdi_divisor(115200)->value, 0xC068);  // 104.125
}

TEST(FtdiDivisor, is_the_nearest_for_every_rate_or_none) {
  std::size_t checks = 0;
  for (std::uint32_t baud = 800; baud < 13000000; baud += baud / 97 + 1) {
    const auto divisor = ftdi_divisor(baud);
    if (!divisor) continue;
    EXPECT_LE(std::abs(divisor->baud - baud), 0.03 * baud);
    EXPECT_DOUBLE_EQ(baud_of(*divisor), divisor->baud) << baud;
    ++checks;
  }
  EXPECT_GT(checks, 800u);
  EXPECT_FALSE(ftdi_divisor(0));
  EXPECT_FALSE(ftdi_divisor(300));
  EXPECT_FALSE(ftdi_divisor(10000000));
  EXPECT_FALSE(ftdi_divisor(20000000));
}

TEST(FtdiData, is_what_follows_the_two_status_bytes_of_every_packet) {
  for (const std::size_t packet : {64u, 512u}) {
    for (const std::size_t length : {0u, 1u, 2u, 61u, 62u, 63u, 509u, 510u, 511u, 5000u}) {
      Bytes data(length);
      std::iota(data.begin(), data.end(), std::uint8_t{0});
      Bytes transfer;
      std::size_t at = 0;
      do {
        append(transfer, Bytes{0x32, 0x60});
        const std::size_t count = std::min(packet - 2, length - at);
        append(transfer, ByteSpan(data).subspan(at, count));
        at += count;
      } while (at < length);
      EXPECT_EQ(ftdi_data(transfer, packet), data) << packet << " " << length;
    }
  }
  EXPECT_TRUE(ftdi_data({}, 512).empty());
  EXPECT_TRUE(ftdi_data(Bytes{0x32}, 512).empty());
}

}  // namespace
