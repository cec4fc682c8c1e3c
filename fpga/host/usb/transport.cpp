// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/usb/transport.h"

#include <algorithm>
#include <utility>

#include "fpga/host/link_error.h"

namespace cbvh::host {

void UsbTransport::connect(FoundBoard found) {
  stream_.reset();
  board_ = found.info;
  endpoints_ = find_endpoints(found, first_interface());
  stream_ = std::make_unique<UsbStream>(context_, found, endpoints_);
  configure();
  stream_->start();
}

void UsbTransport::check_state() {
  switch (stream_ ? stream_->take_state() : UsbStream::State::gone) {
    case UsbStream::State::good:
      return;
    case UsbStream::State::gone:
      throw LinkError(LinkFault::gone, device(), "it was unplugged, or has lost its power: plug it in again");
    case UsbStream::State::overflow:
      throw LinkError(LinkFault::overflow, device(),
                      "it sent more than was asked for: load the gateware of this version");
  }
}

bool UsbTransport::send(Bytes bytes, Milliseconds timeout) {
  check_state();
  const bool sent = stream_->send(std::move(bytes), timeout);
  check_state();
  return sent;
}

Bytes UsbTransport::receive(Milliseconds timeout) {
  check_state();
  const Clock::time_point end = Clock::now() + timeout;
  for (;;) {
    const auto left = std::chrono::ceil<Milliseconds>(end - Clock::now());
    Bytes bytes = data_of(stream_->receive(std::max(left, Milliseconds(0))));
    if (!bytes.empty()) return bytes;
    check_state();
    if (left <= Milliseconds(0)) return {};
  }
}

void UsbTransport::restart() {
  check_state();
  stream_->stop();
  purge();
  stream_->start();
}

bool UsbTransport::reconnect(Milliseconds timeout) {
  constexpr Milliseconds kBetweenLooks{100};  // also where no event tells that a device has come
  stream_.reset();
  BoardChoice same;
  same.by = BoardChoice::By::product_id;
  same.vendor = board_.vendor;
  same.product = board_.product;
  const std::string serial = board_.serial;
  const Clock::time_point end = Clock::now() + timeout;
  for (std::uint64_t changes = 0;;) {
    for (FoundBoard& found : find_boards(context_->get(), same)) {
      if (found.info.serial != serial || !found.info.problem.empty()) continue;
      try {
        connect(std::move(found));
        return true;
      } catch (const LinkError&) {  // it may still be on its way out, or in
        stream_.reset();
      }
    }
    if (Clock::now() >= end) return false;
    changes = context_->wait_for_change(changes, kBetweenLooks);
  }
}

}  // namespace cbvh::host
