// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libusb-1.0/libusb.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "fpga/host/transport.h"

namespace cbvh::host {

/// libusb, and a thread that serves its events for as long as this lives.
class UsbContext {
 public:
  /// Throws LinkError (no_device) where there is no USB.
  UsbContext();
  ~UsbContext();
  UsbContext(const UsbContext&) = delete;
  UsbContext& operator=(const UsbContext&) = delete;

  libusb_context* get() const { return context_; }
  /// Waits until a device has come or gone since the count was taken, or for the timeout. Returns the count.
  std::uint64_t wait_for_change(std::uint64_t since, Milliseconds timeout);

 private:
  static int on_hotplug(libusb_context*, libusb_device*, libusb_hotplug_event, void* self);

  libusb_context* context_ = nullptr;
  libusb_hotplug_callback_handle hotplug_ = 0;
  bool has_hotplug_ = false;
  std::atomic<bool> ends_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t changes_ = 0;
  std::thread events_;
};

}  // namespace cbvh::host
