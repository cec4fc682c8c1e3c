// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The emulated device as the real libusb sees it. Runs with umockdev's library loaded before all others.
#include "fpga/emulator/usb/board.h"

#include <gtest/gtest.h>
#include <libusb.h>

#include <algorithm>
#include <ctime>
#include <thread>

#include "fpga/emulator/usb/preload.h"
#include "tests/support/echo_core.h"

namespace cbvh::testing {
namespace {

using emulator::Fault;
using emulator::FaultKind;
using emulator::Transport;
using Bytes = std::vector<std::uint8_t>;

constexpr unsigned kTimeout = 2000;  // ms

/// A board and a libusb context that sees it.
class Bench {
 public:
  explicit Bench(Transport transport = Transport::bulk, std::vector<Fault> faults = {})
      : link_(core_, std::move(faults), 1), board_(system_, transport, link_) {
    EXPECT_EQ(libusb_init(&context_), 0);
  }
  ~Bench() {
    for (libusb_device_handle* handle : handles_) libusb_close(handle);
    libusb_exit(context_);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  /// Null when there is none of these.
  libusb_device_handle* open(std::uint16_t vendor = 0x1209, std::uint16_t product = 0xB5C0) {
    libusb_device_handle* const handle = libusb_open_device_with_vid_pid(context_, vendor, product);
    if (handle != nullptr) handles_.push_back(handle);
    return handle;
  }
  libusb_context* context() { return context_; }
  emulator::UsbBoard& board() { return board_; }

 private:
  EchoCore core_;
  emulator::Link link_;
  emulator::UsbSystem system_;
  emulator::UsbBoard board_;
  libusb_context* context_ = nullptr;
  std::vector<libusb_device_handle*> handles_;
};

struct Moved {
  int error;
  int bytes;
  bool operator==(const Moved&) const = default;
};

Moved move(libusb_device_handle* handle, unsigned char endpoint, Bytes& bytes, unsigned timeout = kTimeout) {
  Moved moved{0, 0};
  moved.error =
      libusb_bulk_transfer(handle, endpoint, bytes.data(), static_cast<int>(bytes.size()), &moved.bytes, timeout);
  return moved;
}

Bytes counting(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  return bytes;
}

std::string text(libusb_device_handle* handle, std::uint8_t index) {
  unsigned char bytes[100] = {};
  EXPECT_GT(libusb_get_string_descriptor_ascii(handle, index, bytes, sizeof bytes), 0);
  return reinterpret_cast<const char*>(bytes);
}

TEST(UsbBoard, is_what_its_descriptors_say) {
  struct Want {
    Transport transport;
    std::uint16_t vendor;
    std::uint16_t product;
    int interfaces;
  };
  for (const Want& want : {Want{Transport::bulk, 0x1209, 0xB5C0, 1}, Want{Transport::ftdi_uart, 0x0403, 0x6010, 2},
                           Want{Transport::ftdi_fifo, 0x0403, 0x6014, 1}}) {
    Bench bench(want.transport);
    libusb_device_handle* const handle = bench.open(want.vendor, want.product);
    ASSERT_NE(handle, nullptr) << to_string(want.transport);
    EXPECT_EQ(text(handle, 1), "cbvh");
    EXPECT_EQ(text(handle, 2), "cbvh emulated board");
    EXPECT_EQ(text(handle, 3), "EMULATED");
    libusb_config_descriptor* config = nullptr;
    ASSERT_EQ(libusb_get_active_config_descriptor(libusb_get_device(handle), &config), 0);
    EXPECT_EQ(config->bNumInterfaces, want.interfaces);
    EXPECT_EQ(config->interface[0].altsetting[0].bNumEndpoints, 2);
    EXPECT_EQ(config->interface[0].altsetting[0].endpoint[0].wMaxPacketSize, 512);
    libusb_free_config_descriptor(config);
    EXPECT_EQ(libusb_get_device_speed(libusb_get_device(handle)), LIBUSB_SPEED_HIGH);
  }
}

TEST(UsbBoard, carries_a_megabyte_each_way_unchanged) {
  Bench bench;
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  Bytes sent = counting(1U << 20U);
  EXPECT_EQ(move(handle, 0x01, sent), (Moved{0, 1 << 20}));
  Bytes got(1U << 20U);
  EXPECT_EQ(move(handle, 0x81, got), (Moved{0, 1 << 20}));
  EXPECT_EQ(got, sent);
}

TEST(UsbBoard, a_transfer_without_data_times_out_and_does_not_use_the_processor) {
  Bench bench;
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  Bytes got(512);
  const std::clock_t before = std::clock();
  EXPECT_EQ(move(handle, 0x81, got, 400), (Moved{LIBUSB_ERROR_TIMEOUT, 0}));
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 0.2);
  Bytes sent = counting(100);
  EXPECT_EQ(move(handle, 0x01, sent), (Moved{0, 100}));
  EXPECT_EQ(move(handle, 0x81, got), (Moved{0, 100}));  // nothing was lost to the transfer that was given up
}

TEST(UsbBoard, an_interface_belongs_to_one_program_and_a_driver_must_be_detached) {
  Bench bench(Transport::ftdi_uart);
  libusb_device_handle* const one = bench.open(0x0403, 0x6010);
  libusb_device_handle* const other = bench.open(0x0403, 0x6010);
  ASSERT_TRUE(one != nullptr && other != nullptr);
  EXPECT_EQ(libusb_kernel_driver_active(one, 1), 1);
  EXPECT_EQ(libusb_claim_interface(one, 1), LIBUSB_ERROR_BUSY);
  EXPECT_EQ(libusb_detach_kernel_driver(one, 1), 0);
  EXPECT_EQ(libusb_kernel_driver_active(one, 1), 0);
  EXPECT_EQ(libusb_claim_interface(one, 1), 0);
  EXPECT_EQ(libusb_claim_interface(other, 1), LIBUSB_ERROR_BUSY);
  EXPECT_EQ(libusb_release_interface(one, 1), 0);
  EXPECT_EQ(libusb_claim_interface(other, 1), 0);
  EXPECT_EQ(libusb_release_interface(other, 1), 0);
  EXPECT_EQ(libusb_attach_kernel_driver(other, 1), 0);
  EXPECT_EQ(libusb_kernel_driver_active(one, 1), 1);
  EXPECT_EQ(libusb_claim_interface(one, 5), LIBUSB_ERROR_NOT_FOUND);
}

TEST(UsbBoard, control_requests_reach_the_chip_and_unknown_ones_stall) {
  Bench bench(Transport::ftdi_fifo);
  libusb_device_handle* const handle = bench.open(0x0403, 0x6014);
  ASSERT_NE(handle, nullptr);
  unsigned char latency = 0;
  EXPECT_EQ(libusb_control_transfer(handle, 0x40, 0x09, 3, 1, nullptr, 0, kTimeout), 0);
  EXPECT_EQ(libusb_control_transfer(handle, 0xC0, 0x0A, 0, 1, &latency, 1, kTimeout), 1);
  EXPECT_EQ(latency, 3);
  EXPECT_EQ(libusb_control_transfer(handle, 0x40, 0x55, 0, 1, nullptr, 0, kTimeout), LIBUSB_ERROR_PIPE);
  Bytes got(512);
  libusb_set_auto_detach_kernel_driver(handle, 1);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  EXPECT_EQ(move(handle, 0x81, got), (Moved{0, 2}));
}

TEST(UsbBoard, a_stalled_endpoint_works_again_once_cleared) {
  Bench bench(Transport::bulk, {{FaultKind::stall, 0.5}});
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  int stalls = 0;
  Bytes all;
  for (int i = 0; i < 40; ++i) {
    Bytes sent = counting(64);
    const Moved moved = move(handle, 0x01, sent);
    if (moved == Moved{0, 64}) continue;
    EXPECT_EQ(moved, (Moved{LIBUSB_ERROR_PIPE, 0}));
    EXPECT_EQ(move(handle, 0x01, sent), (Moved{LIBUSB_ERROR_PIPE, 0}));
    EXPECT_EQ(libusb_clear_halt(handle, 0x01), 0);
    ++stalls;
  }
  EXPECT_GT(stalls, 5);
  EXPECT_LT(stalls, 35);
}

TEST(UsbBoard, babble_is_an_overflow) {
  Bench bench(Transport::bulk, {{FaultKind::babble, 1}});
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  Bytes bytes = counting(64);
  EXPECT_EQ(move(handle, 0x01, bytes), (Moved{0, 64}));
  EXPECT_EQ(move(handle, 0x81, bytes).error, LIBUSB_ERROR_OVERFLOW);
}

TEST(UsbBoard, an_unplugged_board_fails_all_that_is_asked_of_it) {
  Bench bench(Transport::bulk, {{FaultKind::disconnect, 1}});
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  Bytes bytes(64);
  EXPECT_EQ(move(handle, 0x01, bytes).error, LIBUSB_ERROR_NO_DEVICE);
  EXPECT_EQ(move(handle, 0x81, bytes).error, LIBUSB_ERROR_NO_DEVICE);
  EXPECT_EQ(libusb_release_interface(handle, 0), LIBUSB_ERROR_NO_DEVICE);
  EXPECT_EQ(bench.open(), nullptr);
  EXPECT_EQ(bench.board().plugged(), 1U);
}

TEST(UsbBoard, a_board_that_comes_back_is_announced_and_works) {
  Bench bench(Transport::bulk, {{FaultKind::reconnect, 1}});
  int arrived = 0;
  int left = 0;
  const auto on_plug = [](libusb_context*, libusb_device*, libusb_hotplug_event event, void* counts) {
    ++*static_cast<int**>(counts)[event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED ? 0 : 1];
    return 0;
  };
  int* counts[] = {&arrived, &left};
  ASSERT_EQ(libusb_hotplug_register_callback(
                bench.context(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
                LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, on_plug, counts, nullptr),
            0);
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  Bytes bytes(64);
  EXPECT_EQ(move(handle, 0x01, bytes).error, LIBUSB_ERROR_NO_DEVICE);
  for (int i = 0; i < 100 && arrived == 0; ++i) {
    timeval wait{0, 20'000};
    libusb_handle_events_timeout_completed(bench.context(), &wait, nullptr);
  }
  EXPECT_EQ(left, 1);
  EXPECT_EQ(arrived, 1);
  EXPECT_EQ(bench.board().plugged(), 2U);
  libusb_device_handle* const again = bench.open();
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(libusb_get_device_address(libusb_get_device(again)), 3);
  EXPECT_EQ(libusb_claim_interface(again, 0), 0);
}

TEST(UsbBoard, comes_back_more_often_than_a_port_has_numbers) {
  Bench bench(Transport::bulk, {{FaultKind::reconnect, 1}});
  constexpr unsigned kTimes = 33;
  for (unsigned i = 1; i <= kTimes; ++i) {
    libusb_device_handle* handle = nullptr;
    for (int tries = 0; tries < 500 && handle == nullptr; ++tries) {
      timeval wait{0, 10'000};
      libusb_handle_events_timeout_completed(bench.context(), &wait, nullptr);
      if (bench.board().plugged() == i) handle = bench.open();  // before, it would be the one that leaves
    }
    ASSERT_NE(handle, nullptr) << "time " << i;
    ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
    Bytes bytes(64);
    ASSERT_EQ(move(handle, 0x01, bytes).error, LIBUSB_ERROR_NO_DEVICE);
  }
}

TEST(UsbBoard, transfers_in_flight_can_be_cancelled) {
  Bench bench;
  libusb_device_handle* const handle = bench.open();
  ASSERT_NE(handle, nullptr);
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  constexpr std::size_t kTransfers = 8;
  std::size_t ended = 0;
  Bytes buffers(kTransfers * 512);
  std::vector<libusb_transfer*> transfers;
  for (std::size_t i = 0; i < kTransfers; ++i) {
    libusb_transfer* const transfer = transfers.emplace_back(libusb_alloc_transfer(0));
    libusb_fill_bulk_transfer(
        transfer, handle, 0x81, buffers.data() + 512 * i, 512,
        [](libusb_transfer* done) {
          *static_cast<std::size_t*>(done->user_data) += done->status == LIBUSB_TRANSFER_CANCELLED ? 1 : 0;
        },
        &ended, 0);
    ASSERT_EQ(libusb_submit_transfer(transfer), 0);
  }
  for (libusb_transfer* transfer : transfers) EXPECT_EQ(libusb_cancel_transfer(transfer), 0);
  for (int i = 0; i < 100 && ended < kTransfers; ++i) {
    timeval wait{0, 20'000};
    libusb_handle_events_timeout_completed(bench.context(), &wait, nullptr);
  }
  EXPECT_EQ(ended, kTransfers);
  for (libusb_transfer* transfer : transfers) libusb_free_transfer(transfer);
}

}  // namespace
}  // namespace cbvh::testing

int main(int argc, char** argv) {
  cbvh::emulator::preload_umockdev(argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
