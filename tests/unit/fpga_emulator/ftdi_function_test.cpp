// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/ftdi_function.h"

#include <gtest/gtest.h>

#include "tests/support/echo_core.h"

namespace cbvh::testing {
namespace {

using emulator::FtdiFunction;
using emulator::Link;
using emulator::Setup;
using emulator::Time;
using emulator::Transfer;
using Bytes = std::vector<std::uint8_t>;
using Milliseconds = std::chrono::milliseconds;
using Status = Transfer::Status;

constexpr std::uint8_t kWrite = 0x40;
constexpr std::uint8_t kRead = 0xC0;
constexpr std::uint8_t kIn = 0x83;  // of the second interface
constexpr std::uint8_t kOut = 0x04;
const Time kStart{};

class Ftdi : public ::testing::Test {
 protected:
  bool write(std::uint8_t request, std::uint16_t value, std::uint16_t index = 2) {
    return ftdi.control({kWrite, request, value, index, 0}).has_value();
  }
  std::optional<Bytes> read(std::uint8_t request) { return ftdi.control({kRead, request, 0, 2, 2}); }

  EchoCore core;
  Link link{core, {}, 1};
  FtdiFunction ftdi{link, 1};
};

TEST_F(Ftdi, control_requests_are_those_of_the_chip) {
  EXPECT_EQ(read(0x0A), Bytes{16});
  EXPECT_TRUE(write(0x09, 2));
  EXPECT_EQ(read(0x0A), Bytes{2});
  EXPECT_FALSE(write(0x09, 0));
  EXPECT_FALSE(write(0x09, 256));
  EXPECT_TRUE(write(0x09, 9, 1));  // the other interface's
  EXPECT_EQ(read(0x0A), Bytes{2});
  EXPECT_TRUE(write(0x0B, 0x40FF));
  EXPECT_EQ(ftdi.bit_mode(), 0x40);
  EXPECT_TRUE(write(0x03, 0xC003, 0x0202));
  EXPECT_EQ(ftdi.divisor(), 0x2C003U);
  EXPECT_EQ(read(0x05), (Bytes{0x32, 0x60}));
  for (const std::uint8_t request : Bytes{0x01, 0x02, 0x04, 0x06, 0x07}) EXPECT_TRUE(write(request, 0));
  EXPECT_FALSE(write(0x55, 0));
  EXPECT_FALSE(write(0x00, 3));
  EXPECT_FALSE(read(0x55).has_value());
  EXPECT_FALSE(ftdi.control({0x21, 0x00, 0, 0, 0}).has_value());  // of another class
}

TEST_F(Ftdi, an_idle_chip_sends_two_status_bytes_when_the_latency_timer_runs_out) {
  EXPECT_EQ(ftdi.in(kIn, 512, kStart).status, Status::pending);
  EXPECT_EQ(ftdi.wake(), kStart + Milliseconds(16));
  EXPECT_EQ(ftdi.in(kIn, 512, kStart + Milliseconds(15)).status, Status::pending);
  EXPECT_EQ(ftdi.in(kIn, 512, kStart + Milliseconds(16)).bytes, (Bytes{0x32, 0x60}));
  EXPECT_EQ(ftdi.in(kIn, 512, kStart + Milliseconds(17)).status, Status::pending);
}

TEST_F(Ftdi, data_wait_for_the_timer_unless_they_fill_the_transfer) {
  write(0x09, 4);
  ftdi.in(kIn, 512, kStart);
  ftdi.out(kOut, Bytes{1, 2, 3}, kStart);
  EXPECT_EQ(ftdi.in(kIn, 512, kStart).status, Status::pending);
  EXPECT_EQ(ftdi.in(kIn, 512, kStart + Milliseconds(4)).bytes, (Bytes{0x32, 0x60, 1, 2, 3}));
  ftdi.out(kOut, Bytes(510, 7), kStart);
  const Transfer full = ftdi.in(kIn, 512, kStart + Milliseconds(4));
  EXPECT_EQ(full.status, Status::done);
  EXPECT_EQ(full.bytes.size(), 512U);
}

TEST_F(Ftdi, every_packet_of_a_transfer_begins_with_the_status) {
  Bytes data(1200);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::uint8_t>(i);
  ftdi.out(kOut, data, kStart);
  ftdi.in(kIn, 4096, kStart);
  const Bytes got = ftdi.in(kIn, 4096, kStart + Milliseconds(16)).bytes;
  ASSERT_EQ(got.size(), 1200U + 3 * 2);
  Bytes plain;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (i % 512 < 2) {
      EXPECT_EQ(got[i], i % 512 == 0 ? 0x32 : 0x60) << i;
    } else {
      plain.push_back(got[i]);
    }
  }
  EXPECT_EQ(plain, data);
}

TEST_F(Ftdi, reset_and_purge_forget_what_the_chip_holds) {
  for (std::uint16_t what = 0; what < 3; ++what) {
    ftdi.power_on();
    ftdi.out(kOut, Bytes{5}, kStart);
    ftdi.in(kIn, 512, kStart);  // into the chip
    EXPECT_TRUE(write(0x00, what));
    const std::size_t want = what == 2 ? 3 : 2;  // that purges the other direction
    EXPECT_EQ(ftdi.in(kIn, 512, kStart + Milliseconds(16)).bytes.size(), want) << what;
  }
}

TEST_F(Ftdi, the_other_interface_leads_nowhere) {
  EXPECT_EQ(ftdi.out(0x02, Bytes{5}, kStart).status, Status::done);
  EXPECT_EQ(ftdi.in(0x81, 512, kStart + Milliseconds(999)).status, Status::pending);
  ftdi.in(kIn, 512, kStart);
  EXPECT_EQ(ftdi.in(kIn, 512, kStart + Milliseconds(16)).bytes.size(), 2U);
}

TEST_F(Ftdi, a_transfer_without_room_for_a_packet_babbles) {
  EXPECT_EQ(ftdi.in(kIn, 511, kStart).status, Status::babbled);
}

}  // namespace
}  // namespace cbvh::testing
