// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/ftdi_function.h"

#include <algorithm>

namespace cbvh::emulator {

namespace {
constexpr std::uint8_t kVendorOut = 0x40;
constexpr std::uint8_t kVendorIn = 0xC0;
constexpr std::uint16_t kPurgeReceived = 1;  ///< what is on its way into the host
constexpr std::uint16_t kLastReset = 2;
constexpr std::chrono::milliseconds kDefaultLatency{16};
constexpr std::uint16_t kLastLatency = 255;
}  // namespace

void FtdiFunction::power_on() {
  received_.clear();
  latency_ = kDefaultLatency;
  last_packet_.reset();
  bit_mode_ = 0;
  divisor_ = 0;
}

std::optional<std::vector<std::uint8_t>> FtdiFunction::control(const Setup& setup) {
  std::optional<std::vector<std::uint8_t>> nothing = std::vector<std::uint8_t>();
  const bool into_host = setup.request_type == kVendorIn;
  if (!into_host && setup.request_type != kVendorOut) return std::nullopt;
  // The low byte of the index is the interface, from 1; of a chip with one it may be 0.
  const std::uint8_t interface = static_cast<std::uint8_t>(setup.index & 0xFFU);
  const bool ours = interface == channel_ + 1 || (interface == 0 && channel_ == 0);
  const auto request = static_cast<Request>(setup.request);
  if (into_host) {
    switch (request) {
      case Request::poll_status:
        return std::vector{kModemStatus, kLineStatus};
      case Request::get_latency:
        return std::vector{static_cast<std::uint8_t>(latency_.count())};
      case Request::read_pins:
        return std::vector<std::uint8_t>{0};
      case Request::read_eeprom:
        return std::vector<std::uint8_t>{0xFF, 0xFF};  // there is none
      default:
        return std::nullopt;
    }
  }
  switch (request) {
    case Request::reset:
      if (setup.value > kLastReset) return std::nullopt;
      if (ours && setup.value <= kPurgeReceived) received_.clear();
      return nothing;
    case Request::baud_rate:
      // 14 bits and two of the fraction in the value, the last of the fraction and the clock in the index's high byte.
      if (ours) divisor_ = setup.value | (std::uint32_t{setup.index} >> 8U << 16U);
      return nothing;
    case Request::set_latency:
      if (setup.value == 0 || setup.value > kLastLatency) return std::nullopt;
      if (ours) latency_ = std::chrono::milliseconds(setup.value);
      return nothing;
    case Request::bit_mode:
      if (ours) bit_mode_ = static_cast<std::uint8_t>(setup.value >> 8U);
      return nothing;
    case Request::modem_control:
    case Request::flow_control:
    case Request::line:
    case Request::event_character:
    case Request::error_character:
      return nothing;
    default:
      return std::nullopt;
  }
}

Transfer FtdiFunction::out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes, Time now) {
  return is_ours(endpoint) ? link_.out(bytes, now) : Transfer();
}

std::vector<std::uint8_t> FtdiFunction::packets(std::span<const std::uint8_t> data) {
  constexpr std::size_t kData = kPacketBytes - kStatusBytes;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(data.size() + kStatusBytes * (data.size() / kData + 1));
  do {
    const auto packet = data.first(std::min(kData, data.size()));
    bytes.push_back(kModemStatus);
    bytes.push_back(kLineStatus);
    bytes.insert(bytes.end(), packet.begin(), packet.end());
    data = data.subspan(packet.size());
  } while (!data.empty());
  return bytes;
}

Transfer FtdiFunction::in(std::uint8_t endpoint, std::size_t most, Time now) {
  if (!is_ours(endpoint)) return {Transfer::Status::pending};
  const std::size_t room = most / kPacketBytes * (kPacketBytes - kStatusBytes);
  if (room == 0) return {Transfer::Status::babbled};  // not even one packet fits
  if (!last_packet_) last_packet_ = now;
  while (received_.size() < room) {
    Transfer transfer = link_.in(room - received_.size(), now);
    if (transfer.status == Transfer::Status::pending) break;
    if (transfer.status != Transfer::Status::done) return transfer;
    received_.insert(received_.end(), transfer.bytes.begin(), transfer.bytes.end());
  }
  if (received_.size() < room && now < *last_packet_ + latency_) return {Transfer::Status::pending};
  last_packet_ = now;
  const std::size_t sent = std::min(room, received_.size());
  Transfer transfer{Transfer::Status::done, packets(std::span(received_).first(sent))};
  received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(sent));
  return transfer;
}

void FtdiFunction::clear_halt(std::uint8_t endpoint) {
  if (is_ours(endpoint)) link_.clear_halt((endpoint & 0x80U) != 0 ? Direction::in : Direction::out);
}

std::optional<Time> FtdiFunction::wake() const {
  const std::optional<Time> link = link_.wake();
  if (!last_packet_) return link;
  const Time timer = *last_packet_ + latency_;
  return link ? std::min(*link, timer) : timer;
}

}  // namespace cbvh::emulator
