// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/boards.h"

#include <gtest/gtest.h>

#include "golden/input_error.h"

namespace {

using namespace cbvh::host;
using cbvh::golden::InputError;

TEST(BoardChoice, reads_each_of_its_forms) {
  EXPECT_EQ(BoardChoice::parse("--device", "").by, BoardChoice::By::only_one);
  const BoardChoice id = BoardChoice::parse("--device", "usb:1209:b5c0");
  EXPECT_EQ(id.by, BoardChoice::By::product_id);
  EXPECT_EQ(id.vendor, 0x1209);
  EXPECT_EQ(id.product, 0xB5C0);
  const BoardChoice serial = BoardChoice::parse("--device", "serial=a:b=c");
  EXPECT_EQ(serial.by, BoardChoice::By::serial);
  EXPECT_EQ(serial.serial, "a:b=c");
  const BoardChoice address = BoardChoice::parse("--device", "3:017");
  EXPECT_EQ(address.by, BoardChoice::By::address);
  EXPECT_EQ(address.bus, 3);
  EXPECT_EQ(address.address, 17);
}

TEST(BoardChoice, refuses_what_is_none_of_them_with_the_option_as_place) {
  for (const char* text : {"usb", "usb:", "usb:12", "usb:12345:0", "usb:12:", "usb:xy:12", "usb:1:2 ", "serial=", "1",
                           "1:", ":1", "256:1", "1:256", "-1:2", "1:2:3", "ttyUSB0"}) {
    try {
      BoardChoice::parse("--device", text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), "--device");
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos);
    }
  }
}

TEST(BoardInfo, names_the_device_as_far_as_it_is_known) {
  BoardInfo info;
  info.vendor = 0x1209;
  info.product = 0xB5C0;
  info.bus = 1;
  info.address = 5;
  EXPECT_EQ(info.device(), "usb 1:5 1209:b5c0");
  EXPECT_FALSE(info.ours());
  info.product_name = "cbvh board";
  info.serial = "17";
  EXPECT_EQ(info.device(), "usb 1:5 1209:b5c0 'cbvh board' serial 17");
  EXPECT_TRUE(info.ours());
}

}  // namespace
