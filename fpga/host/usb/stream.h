// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libusb-1.0/libusb.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "fpga/host/usb/context.h"
#include "fpga/host/usb/device.h"

namespace cbvh::host {

/// Two bulk endpoints of an open device, with several transfers under way on both. Transfers end on the context's
/// thread; one other thread calls the members.
class UsbStream {
 public:
  enum class State : std::uint8_t { good, gone, overflow };

  /// Claims the interface and asks for data. Throws LinkError: busy, gone.
  UsbStream(std::shared_ptr<UsbContext> context, const FoundBoard& board, const Endpoints& endpoints);
  /// Ends all transfers and gives the interface back.
  ~UsbStream();
  UsbStream(const UsbStream&) = delete;
  UsbStream& operator=(const UsbStream&) = delete;

  /// Begins to ask for data.
  void start();
  /// False when too many transfers are under way for longer than the timeout.
  bool send(Bytes bytes, Milliseconds timeout);
  /// What the next transfer has brought.
  Bytes receive(Milliseconds timeout);
  /// Ends all transfers, throws away what they have brought, and clears halts. start() begins anew.
  void stop();
  /// What went wrong; an overflow is told once.
  State take_state();

  libusb_device_handle* handle() const { return handle_.get(); }

 private:
  struct Transfer {
    UsbStream* stream = nullptr;
    libusb_transfer* usb = nullptr;
    std::uint8_t endpoint = 0;
    Bytes buffer;
    bool under_way = false;
  };

  static void on_end(libusb_transfer* usb);
  void end_in(Transfer& transfer);
  void end_out(Transfer& transfer);
  /// Both want the mutex held.
  void submit(Transfer& transfer);
  void note_status(int status);
  /// Clears halts and asks for data again where asking has stopped. Called with the mutex held, which it drops
  /// meanwhile.
  void heal(std::unique_lock<std::mutex>& lock);
  void cancel_all(std::unique_lock<std::mutex>& lock);

  static constexpr std::size_t kInTransfers = 4;
  static constexpr std::size_t kOutTransfers = 8;
  static constexpr std::size_t kInBytes = 65536;
  static constexpr std::size_t kGreatestBacklog = std::size_t{64} << 20;  ///< then asking stops until it is read
  static constexpr unsigned kGreatestErrors = 16;                         ///< in a row, until the device counts as gone

  std::shared_ptr<UsbContext> context_;
  UsbHandle handle_;
  Endpoints endpoints_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::unique_ptr<Transfer>> in_;
  std::vector<std::unique_ptr<Transfer>> out_;
  std::deque<Bytes> received_;
  std::size_t backlog_ = 0;  ///< bytes of received_
  unsigned errors_ = 0;      ///< in a row
  bool running_ = false;
  bool in_halted_ = false;
  bool out_halted_ = false;
  State state_ = State::good;
};

}  // namespace cbvh::host
