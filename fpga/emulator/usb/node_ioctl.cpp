// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "fpga/emulator/usb/node.h"

/// The ioctls of a device's node, as the kernel's usbfs has them.
namespace cbvh::emulator {

namespace {

constexpr std::uint32_t kCapabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                        USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
constexpr char kDriver[] = "ftdi_sio";
constexpr char kUsbfs[] = "usbfs";

/// What an ioctl's argument points to; null when it cannot be read.
template <class T>
T* pointed_to(UMockdevIoctlData& argument) {
  const Reference<UMockdevIoctlData> data(umockdev_ioctl_data_resolve(&argument, 0, sizeof(T), nullptr));
  return data ? reinterpret_cast<T*>(data->data) : nullptr;  // the argument keeps it
}

/// Of an argument that is a number or a pointer as such.
gulong value_of(const UMockdevIoctlData& argument) {
  gulong value = 0;
  std::memcpy(&value, argument.data, sizeof value);
  return value;
}

}  // namespace

UsbNode::Result UsbNode::ioctl(UMockdevIoctlClient& client) {
  constexpr Result kDone{0, 0};
  constexpr Result kBadAddress{-1, EFAULT};
  UMockdevIoctlData& argument = *umockdev_ioctl_client_get_arg(&client);
  const gulong request = umockdev_ioctl_client_get_request(&client);
  if (request == USBDEVFS_REAPURBNDELAY) return reap(client, argument);
  if (request == USBDEVFS_DISCARDURB) return discard(value_of(argument));
  {
    const std::lock_guard lock(mutex_);
    if (gone_) return {-1, ENODEV};
  }
  switch (request) {
    case USBDEVFS_SUBMITURB:
      return submit(client, argument);
    case USBDEVFS_GET_CAPABILITIES: {
      auto* const capabilities = pointed_to<std::uint32_t>(argument);
      if (capabilities == nullptr) return kBadAddress;
      *capabilities = kCapabilities;
      return kDone;
    }
    case USBDEVFS_CLAIMINTERFACE: {
      const auto* const interface = pointed_to<unsigned>(argument);
      return interface == nullptr ? kBadAddress : claim(client, *interface, false);
    }
    case USBDEVFS_DISCONNECT_CLAIM: {
      const auto* const wanted = pointed_to<usbdevfs_disconnect_claim>(argument);
      return wanted == nullptr ? kBadAddress : claim(client, wanted->interface, true);
    }
    case USBDEVFS_RELEASEINTERFACE: {
      const auto* const interface = pointed_to<unsigned>(argument);
      return interface == nullptr ? kBadAddress : release(client, *interface);
    }
    case USBDEVFS_CLEAR_HALT: {
      const auto* const endpoint = pointed_to<unsigned>(argument);
      if (endpoint == nullptr) return kBadAddress;
      if (!has_endpoint(transport_, static_cast<std::uint8_t>(*endpoint))) return {-1, ENOENT};
      {
        const std::lock_guard lock(function_mutex_);
        function_.clear_halt(static_cast<std::uint8_t>(*endpoint));
      }
      interrupt();
      return kDone;
    }
    case USBDEVFS_GETDRIVER:
      return driver_name(argument);
    case USBDEVFS_IOCTL:
      return driver_request(argument);
    case USBDEVFS_SETCONFIGURATION:
    case USBDEVFS_SETINTERFACE:
    case USBDEVFS_RESET:
      return kDone;
    default:
      return {-1, ENOTTY};
  }
}

UsbNode::Result UsbNode::submit(UMockdevIoctlClient& client, UMockdevIoctlData& argument) {
  UrbPointer urb = Urb::read(argument);
  if (!urb) return {-1, EFAULT};
  const bool control = urb->head().type == USBDEVFS_URB_TYPE_CONTROL;
  if (control ? urb->buffer().size() < sizeof(Setup) : urb->head().type != USBDEVFS_URB_TYPE_BULK) {
    return {-1, EINVAL};
  }
  if (!control && !has_endpoint(transport_, urb->endpoint())) return {-1, ENOENT};
  urb->client = &client;
  const std::lock_guard lock(mutex_);
  if (gone_) return {-1, ENODEV};
  pending_.push_back(std::move(urb));
  interrupted_ = true;
  changed_.notify_all();
  return {0, 0};
}

UsbNode::Result UsbNode::discard(gulong address) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(pending_.begin(), pending_.end(), [&](const auto& urb) { return urb->address() == address; });
  if (found != pending_.end()) {
    UrbPointer urb = std::move(*found);
    pending_.erase(found);
    urb->head().actual_length = 0;
    finish(std::move(urb), -ENOENT);
    return {0, 0};
  }
  if (carried_out_ == nullptr || carried_out_->address() != address) return {-1, EINVAL};
  carried_out_->discarded = true;
  return {0, 0};
}

UsbNode::Result UsbNode::reap(UMockdevIoctlClient& client, UMockdevIoctlData& argument) {
  UrbPointer urb;
  {
    const std::lock_guard lock(mutex_);
    std::deque<UrbPointer>& done = done_[&client];
    if (done.empty()) return {-1, gone_ ? ENODEV : EAGAIN};
    urb = std::move(done.front());
    done.pop_front();
    show_reapable();
  }
  const Reference<UMockdevIoctlData> slot(umockdev_ioctl_data_resolve(&argument, 0, sizeof(void*), nullptr));
  if (!slot || umockdev_ioctl_data_set_ptr(slot.get(), 0, &urb->request()) == 0) return {-1, EFAULT};
  return {0, 0};
}

UsbNode::Result UsbNode::claim(UMockdevIoctlClient& client, unsigned interface, bool with_driver) {
  if (interface >= interface_count(transport_)) return {-1, ENOENT};
  const std::lock_guard lock(mutex_);
  const auto owner = claimed_.find(interface);
  if (owner != claimed_.end()) return owner->second == &client ? Result{0, 0} : Result{-1, EBUSY};
  if (with_driver) drivers_.erase(interface);
  if (drivers_.count(interface) != 0) return {-1, EBUSY};
  claimed_[interface] = &client;
  return {0, 0};
}

UsbNode::Result UsbNode::release(UMockdevIoctlClient& client, unsigned interface) {
  const std::lock_guard lock(mutex_);
  const auto owner = claimed_.find(interface);
  if (owner == claimed_.end() || owner->second != &client) return {-1, EINVAL};
  claimed_.erase(owner);
  return {0, 0};
}

UsbNode::Result UsbNode::driver_name(UMockdevIoctlData& argument) {
  auto* const asked = pointed_to<usbdevfs_getdriver>(argument);
  if (asked == nullptr) return {-1, EFAULT};
  const std::lock_guard lock(mutex_);
  const bool of_kernel = drivers_.count(asked->interface) != 0;
  if (!of_kernel && claimed_.count(asked->interface) == 0) return {-1, ENODATA};
  std::strncpy(asked->driver, of_kernel ? kDriver : kUsbfs, sizeof asked->driver - 1);
  return {0, 0};
}

/// Detaching and attaching of the kernel's driver.
UsbNode::Result UsbNode::driver_request(UMockdevIoctlData& argument) {
  const auto* const asked = pointed_to<usbdevfs_ioctl>(argument);
  if (asked == nullptr) return {-1, EFAULT};
  const auto interface = static_cast<unsigned>(asked->ifno);
  const std::lock_guard lock(mutex_);
  if (asked->ioctl_code == static_cast<int>(USBDEVFS_DISCONNECT)) {
    return drivers_.erase(interface) != 0 ? Result{0, 0} : Result{-1, ENODATA};
  }
  if (asked->ioctl_code != static_cast<int>(USBDEVFS_CONNECT) || transport_ == Transport::bulk) return {-1, ENODATA};
  if (claimed_.count(interface) != 0) return {-1, EBUSY};
  drivers_.insert(interface);
  return {1, 0};
}

void UsbNode::forget(UMockdevIoctlClient& client) {
  const std::lock_guard lock(mutex_);
  std::erase_if(pending_, [&](const auto& urb) { return urb->client == &client; });
  if (carried_out_ != nullptr && carried_out_->client == &client) carried_out_->client = nullptr;
  done_.erase(&client);
  std::erase_if(claimed_, [&](const auto& entry) { return entry.second == &client; });
  show_reapable();
}

}  // namespace cbvh::emulator
