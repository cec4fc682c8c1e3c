// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What the host says of a board that it cannot open. Runs with umockdev's library loaded before all others.
#include <gtest/gtest.h>
#include <libusb.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <filesystem>

#include "fpga/emulator/usb/board.h"
#include "fpga/emulator/usb/preload.h"
#include "fpga/host/boards.h"
#include "fpga/host/link_error.h"
#include "tests/support/echo_core.h"

namespace cbvh::testing {
namespace {

using emulator::Transport;
using host::BoardChoice;
using host::LinkError;
using host::LinkFault;

/// A core behind its link.
struct Inside {
  EchoCore core;
  emulator::Link link{core, {}, 1};
};

/// The error of opening the board of this choice; none is a failure of the test.
LinkError error_of(const std::string& choice) {
  try {
    host::open_board(BoardChoice::parse("--device", choice));
  } catch (const LinkError& error) {
    return error;
  }
  ADD_FAILURE() << "opened '" << choice << "'";
  return LinkError(LinkFault::timeout, "", "");
}

std::string opened_device(const std::string& choice) {
  return host::open_board(BoardChoice::parse("--device", choice))->device();
}

TEST(OpenBoard, the_only_one_is_opened_without_being_named) {
  emulator::UsbSystem system;
  Inside inside;
  emulator::UsbBoard board(system, Transport::bulk, inside.link);
  EXPECT_EQ(opened_device(""), "usb 1:2 1209:b5c0 'cbvh emulated board' serial EMULATED");
}

TEST(OpenBoard, none_says_what_was_looked_for) {
  emulator::UsbSystem system;
  const LinkError any = error_of("");
  EXPECT_EQ(any.fault(), LinkFault::no_device);
  EXPECT_STREQ(any.what(),
               "board: no board is plugged in (1209:b5c0, or an FTDI chip whose product name begins with 'cbvh'); "
               "'lsusb' lists what is, --device chooses another");
  const LinkError named = error_of("serial=17");
  EXPECT_EQ(named.fault(), LinkFault::no_device);
  EXPECT_STREQ(named.what(), "board serial=17: no such device is plugged in; 'cbvh board list' shows those that are");
}

TEST(OpenBoard, one_that_another_program_has_is_busy_and_says_how_to_find_that_program) {
  emulator::UsbSystem system;
  Inside inside;
  emulator::UsbBoard board(system, Transport::bulk, inside.link);
  libusb_context* context = nullptr;
  ASSERT_EQ(libusb_init(&context), 0);
  libusb_device_handle* const other = libusb_open_device_with_vid_pid(context, 0x1209, 0xB5C0);
  ASSERT_NE(other, nullptr);
  ASSERT_EQ(libusb_claim_interface(other, 0), 0);
  const LinkError error = error_of("");
  EXPECT_EQ(error.fault(), LinkFault::busy);
  EXPECT_STREQ(error.what(),
               "usb 1:2 1209:b5c0 'cbvh emulated board' serial EMULATED: another program has it: "
               "'fuser -v /dev/bus/usb/001/002' names it");
  EXPECT_EQ(libusb_release_interface(other, 0), 0);
  EXPECT_EQ(opened_device(""), "usb 1:2 1209:b5c0 'cbvh emulated board' serial EMULATED");
  libusb_close(other);
  libusb_exit(context);
}

/// While it lives this process may not open the device's node: root becomes somebody else, whom the mocked system lets
/// see everything but that.
class Stranger {
 public:
  Stranger(const emulator::UsbSystem& system, const std::string& node) : was_(geteuid()) {
    namespace fs = std::filesystem;
    fs::permissions(system.root(), fs::perms::all);  // libusb's end of the mocked udev makes a socket there
    for (const auto& entry : fs::recursive_directory_iterator(system.root())) {
      if (!entry.is_symlink()) fs::permissions(entry.path(), fs::perms::all);
    }
    fs::permissions(system.root() + node, fs::perms::none);
    EXPECT_EQ(was_ == 0 ? seteuid(kNobody) : 0, 0);
  }
  ~Stranger() {
    EXPECT_EQ(was_ == 0 ? seteuid(was_) : 0, 0);
    prctl(PR_SET_DUMPABLE, 1);  // the leak sanitizer wants to look at this process
  }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  const uid_t was_;
};

TEST(OpenBoard, without_permission_it_names_the_device_and_the_udev_rules) {
  emulator::UsbSystem system;
  Inside inside;
  emulator::UsbBoard board(system, Transport::bulk, inside.link);
  {
    const Stranger stranger(system, "/dev/bus/usb/001/002");
    const std::string what =
        "usb 1:2 1209:b5c0: no permission to open it: copy fpga/host/60-cbvh.rules to /etc/udev/rules.d, run "
        "'udevadm control --reload' and plug it in again";
    const LinkError only = error_of("");
    EXPECT_EQ(only.fault(), LinkFault::no_permission);
    EXPECT_EQ(only.what(), "board: " + what);
    const LinkError serial = error_of("serial=EMULATED");
    EXPECT_EQ(serial.fault(), LinkFault::no_permission);
    EXPECT_EQ(serial.what(), "board serial=EMULATED: " + what);
    for (const char* choice : {"1:2", "usb:1209:b5c0"}) {
      const LinkError named = error_of(choice);
      EXPECT_EQ(named.fault(), LinkFault::no_permission) << choice;
      EXPECT_EQ(named.what(), what);
    }
    const auto listed = host::list_boards();
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_NE(listed[0].problem.find("60-cbvh.rules"), std::string::npos);
  }
  std::filesystem::permissions(system.root() + "/dev/bus/usb/001/002", std::filesystem::perms::owner_all);
  EXPECT_EQ(opened_device(""), "usb 1:2 1209:b5c0 'cbvh emulated board' serial EMULATED");
}

TEST(OpenBoard, of_several_one_must_be_chosen_and_the_error_names_them) {
  emulator::UsbSystem system;
  Inside first;
  Inside second;
  Inside third;
  emulator::UsbBoard board(system, Transport::bulk, first.link);
  emulator::UsbBoard same(system, Transport::bulk, second.link, 2);
  emulator::UsbBoard other(system, Transport::ftdi_uart, third.link, 3);
  ASSERT_EQ(host::list_boards().size(), 3U);
  const std::string bulk = "usb 1:2 1209:b5c0 'cbvh emulated board' serial EMULATED";
  const std::string bulk_too = "usb 1:33 1209:b5c0 'cbvh emulated board' serial EMULATED";
  const std::string uart = "usb 1:64 0403:6010 'cbvh emulated board' serial EMULATED";
  const std::string advice = "choose with --device BUS:ADDRESS or serial=TEXT";
  for (const char* choice : {"", "serial=EMULATED"}) {
    const LinkError error = error_of(choice);
    EXPECT_EQ(error.fault(), LinkFault::ambiguous) << choice;
    EXPECT_EQ(error.message().substr(0, 2), "3 ");
    for (const std::string& text : {bulk, bulk_too, uart, advice}) {
      EXPECT_NE(error.message().find(text), std::string::npos) << error.what();
    }
  }
  const LinkError two = error_of("usb:1209:b5c0");
  EXPECT_EQ(two.fault(), LinkFault::ambiguous);
  EXPECT_EQ(two.message().substr(0, 2), "2 ");
  EXPECT_EQ(two.message().find(uart), std::string::npos);
  EXPECT_EQ(opened_device("1:2"), bulk);
  EXPECT_EQ(opened_device("1:33"), bulk_too);
  EXPECT_EQ(opened_device("usb:0403:6010"), uart);
}

}  // namespace
}  // namespace cbvh::testing

int main(int argc, char** argv) {
  cbvh::emulator::preload_umockdev(argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
