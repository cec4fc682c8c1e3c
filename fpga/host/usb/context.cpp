// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/usb/context.h"

#include "fpga/host/link_error.h"

namespace cbvh::host {

UsbContext::UsbContext() {
  const int error = libusb_init(&context_);
  if (error != 0) {
    throw LinkError(LinkFault::no_device, "board",
                    fmt::format("no USB on this machine ({})", libusb_error_name(error)));
  }
  if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0) {
    has_hotplug_ = libusb_hotplug_register_callback(
                       context_, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
                       LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, &on_hotplug, this,
                       &hotplug_) == LIBUSB_SUCCESS;
  }
  events_ = std::thread([this] {
    while (!ends_) {
      timeval second{1, 0};
      libusb_handle_events_timeout_completed(context_, &second, nullptr);
    }
  });
}

UsbContext::~UsbContext() {
  ends_ = true;
  libusb_interrupt_event_handler(context_);
  events_.join();
  if (has_hotplug_) libusb_hotplug_deregister_callback(context_, hotplug_);
  libusb_exit(context_);
}

int UsbContext::on_hotplug(libusb_context*, libusb_device*, libusb_hotplug_event, void* self) {
  auto& context = *static_cast<UsbContext*>(self);
  const std::lock_guard lock(context.mutex_);
  ++context.changes_;
  context.changed_.notify_all();
  return 0;
}

std::uint64_t UsbContext::wait_for_change(std::uint64_t since, Milliseconds timeout) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [&] { return changes_ != since; });
  return changes_;
}

}  // namespace cbvh::host
