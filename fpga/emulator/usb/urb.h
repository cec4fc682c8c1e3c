// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace cbvh::emulator {

struct Unref {
  void operator()(gpointer object) const { g_object_unref(object); }
};
/// A counted reference.
template <class T>
using Reference = std::unique_ptr<T, Unref>;

/// A transfer that a program has submitted, as it lies in the program's memory: the request and its buffer. What is
/// written here reaches the program when it reaps the transfer.
class Urb {
 public:
  /// `argument` is SUBMITURB's, which points to the request. Empty when the program's memory cannot be read.
  static std::unique_ptr<Urb> read(UMockdevIoctlData& argument) {
    Reference<UMockdevIoctlData> request(umockdev_ioctl_data_resolve(&argument, 0, sizeof(usbdevfs_urb), nullptr));
    if (!request) return nullptr;
    auto urb = std::unique_ptr<Urb>(new Urb(std::move(request)));
    const auto length = static_cast<gsize>(urb->head().buffer_length);
    if (length != 0) {
      urb->buffer_.reset(
          umockdev_ioctl_data_resolve(urb->request_.get(), offsetof(usbdevfs_urb, buffer), length, nullptr));
      if (!urb->buffer_) return nullptr;
    }
    return urb;
  }

  usbdevfs_urb& head() { return *reinterpret_cast<usbdevfs_urb*>(request_->data); }
  std::uint8_t endpoint() { return head().endpoint; }
  std::span<std::uint8_t> buffer() {
    return buffer_ ? std::span(buffer_->data, static_cast<std::size_t>(buffer_->data_len)) : std::span<std::uint8_t>();
  }
  /// The request's address in the program.
  gulong address() const { return request_->client_addr; }
  UMockdevIoctlData& request() { return *request_; }

  bool discarded = false;  ///< while its transfer is being carried out
  UMockdevIoctlClient* client = nullptr;

 private:
  explicit Urb(Reference<UMockdevIoctlData> request) : request_(std::move(request)) {}

  Reference<UMockdevIoctlData> request_;
  Reference<UMockdevIoctlData> buffer_;
};

}  // namespace cbvh::emulator
