// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/usb/stream.h"

#include <algorithm>
#include <utility>

#include "fpga/host/link_error.h"

namespace cbvh::host {

UsbStream::UsbStream(std::shared_ptr<UsbContext> context, const FoundBoard& board, const Endpoints& endpoints)
    : context_(std::move(context)), handle_(open_device(board)), endpoints_(endpoints) {
  libusb_set_auto_detach_kernel_driver(handle(), 1);
  const int error = libusb_claim_interface(handle(), endpoints_.interface);
  if (error != 0) fail_usb(board.info, error, "its interface cannot be claimed");
  const auto make = [this](std::size_t count, std::uint8_t endpoint,
                           std::vector<std::unique_ptr<Transfer>>& transfers) {
    for (std::size_t i = 0; i < count; ++i) {
      auto transfer = std::make_unique<Transfer>();
      transfer->stream = this;
      transfer->endpoint = endpoint;
      transfer->usb = libusb_alloc_transfer(0);
      transfers.push_back(std::move(transfer));
    }
  };
  make(kInTransfers, endpoints_.in, in_);
  make(kOutTransfers, endpoints_.out, out_);
  for (const auto& transfer : in_) transfer->buffer.resize(kInBytes);
}

UsbStream::~UsbStream() {
  {
    std::unique_lock lock(mutex_);
    cancel_all(lock);
  }
  for (const auto& transfer : in_) libusb_free_transfer(transfer->usb);
  for (const auto& transfer : out_) libusb_free_transfer(transfer->usb);
  libusb_release_interface(handle(), endpoints_.interface);
}

void UsbStream::start() {
  const std::lock_guard lock(mutex_);
  running_ = true;
  for (const auto& transfer : in_) {
    if (!transfer->under_way) submit(*transfer);
  }
}

void UsbStream::stop() {
  std::unique_lock lock(mutex_);
  cancel_all(lock);
  received_.clear();
  backlog_ = 0;
  in_halted_ = out_halted_ = true;
  heal(lock);
}

void UsbStream::cancel_all(std::unique_lock<std::mutex>& lock) {
  running_ = false;
  const auto under_way = [](const auto& transfer) { return transfer->under_way; };
  for (const auto* transfers : {&in_, &out_}) {
    for (const auto& transfer : *transfers) {
      if (under_way(transfer)) libusb_cancel_transfer(transfer->usb);
    }
  }
  changed_.wait(lock, [&] {
    return std::none_of(in_.begin(), in_.end(), under_way) && std::none_of(out_.begin(), out_.end(), under_way);
  });
}

void UsbStream::submit(Transfer& transfer) {
  libusb_fill_bulk_transfer(transfer.usb, handle(), transfer.endpoint, transfer.buffer.data(),
                            static_cast<int>(transfer.buffer.size()), &on_end, &transfer, 0);
  transfer.under_way = true;
  const int error = libusb_submit_transfer(transfer.usb);
  if (error == 0) return;
  transfer.under_way = false;
  note_status(error == LIBUSB_ERROR_NO_DEVICE ? LIBUSB_TRANSFER_NO_DEVICE : LIBUSB_TRANSFER_ERROR);
  changed_.notify_all();
}

void UsbStream::on_end(libusb_transfer* usb) {
  auto& transfer = *static_cast<Transfer*>(usb->user_data);
  UsbStream& stream = *transfer.stream;
  const std::lock_guard lock(stream.mutex_);
  transfer.under_way = false;
  (usb->endpoint & LIBUSB_ENDPOINT_IN) != 0 ? stream.end_in(transfer) : stream.end_out(transfer);
  stream.changed_.notify_all();
}

void UsbStream::note_status(int status) {
  switch (status) {
    case LIBUSB_TRANSFER_NO_DEVICE:
      state_ = State::gone;
      return;
    case LIBUSB_TRANSFER_OVERFLOW:
      if (state_ == State::good) state_ = State::overflow;
      return;
    case LIBUSB_TRANSFER_ERROR:
      if (++errors_ >= kGreatestErrors) state_ = State::gone;
      return;
    case LIBUSB_TRANSFER_COMPLETED:
      errors_ = 0;
      return;
    default:
      return;
  }
}

void UsbStream::end_in(Transfer& transfer) {
  const libusb_transfer& usb = *transfer.usb;
  note_status(usb.status);
  if (usb.actual_length > 0) {
    received_.emplace_back(transfer.buffer.begin(), transfer.buffer.begin() + usb.actual_length);
    backlog_ += received_.back().size();
  }
  if (usb.status == LIBUSB_TRANSFER_STALL || usb.status == LIBUSB_TRANSFER_ERROR) in_halted_ = true;
  if (running_ && !in_halted_ && state_ != State::gone && backlog_ <= kGreatestBacklog) submit(transfer);
}

void UsbStream::end_out(Transfer& transfer) {
  note_status(transfer.usb->status);
  if (transfer.usb->status == LIBUSB_TRANSFER_STALL || transfer.usb->status == LIBUSB_TRANSFER_ERROR) {
    out_halted_ = true;
  }
}

void UsbStream::heal(std::unique_lock<std::mutex>& lock) {
  const bool in = std::exchange(in_halted_, false);
  const bool out = std::exchange(out_halted_, false);
  if (state_ == State::gone) return;
  if (in || out) {
    lock.unlock();
    if (in) libusb_clear_halt(handle(), endpoints_.in);
    if (out) libusb_clear_halt(handle(), endpoints_.out);
    lock.lock();
  }
  if (!running_ || backlog_ > kGreatestBacklog) return;
  for (const auto& transfer : in_) {
    if (!transfer->under_way && state_ != State::gone) submit(*transfer);
  }
}

bool UsbStream::send(Bytes bytes, Milliseconds timeout) {
  std::unique_lock lock(mutex_);
  heal(lock);
  Transfer* free = nullptr;
  changed_.wait_for(lock, timeout, [&] {
    const auto found = std::find_if(out_.begin(), out_.end(), [](const auto& other) { return !other->under_way; });
    free = found == out_.end() ? nullptr : found->get();
    return free != nullptr || state_ == State::gone;
  });
  if (free == nullptr || state_ == State::gone) return false;
  free->buffer = std::move(bytes);
  submit(*free);
  return free->under_way;
}

Bytes UsbStream::receive(Milliseconds timeout) {
  std::unique_lock lock(mutex_);
  const Clock::time_point end = Clock::now() + timeout;
  for (;;) {
    if (!received_.empty()) {
      Bytes bytes = std::move(received_.front());
      received_.pop_front();
      backlog_ -= bytes.size();
      return bytes;
    }
    heal(lock);
    if (state_ != State::good || Clock::now() >= end) return {};
    changed_.wait_until(lock, end, [&] { return !received_.empty() || in_halted_ || state_ != State::good; });
  }
}

UsbStream::State UsbStream::take_state() {
  const std::lock_guard lock(mutex_);
  return state_ == State::overflow ? std::exchange(state_, State::good) : state_;
}

}  // namespace cbvh::host
