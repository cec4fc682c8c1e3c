// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fpga/emulator/link/function.h"

namespace cbvh::emulator {

/// One channel of an FT232H or FT2232H. Every packet into the host begins with two status bytes; a packet that is not
/// full is sent when the latency timer has run out, be there data for it or not, and ends the transfer.
class FtdiFunction final : public Function {
 public:
  static constexpr std::size_t kPacketBytes = 512;
  static constexpr std::size_t kStatusBytes = 2;
  static constexpr std::uint8_t kModemStatus = 0x32;  ///< clear to send, data set ready; the reserved bit
  static constexpr std::uint8_t kLineStatus = 0x60;   ///< transmitter empty
  enum class Request : std::uint8_t {
    reset = 0x00,
    modem_control = 0x01,
    flow_control = 0x02,
    baud_rate = 0x03,
    line = 0x04,
    poll_status = 0x05,
    event_character = 0x06,
    error_character = 0x07,
    set_latency = 0x09,
    get_latency = 0x0A,
    bit_mode = 0x0B,
    read_pins = 0x0C,
    read_eeprom = 0x90
  };

  /// `channel`: 0 for the first interface, 1 for the second; transfers and requests of another do nothing.
  FtdiFunction(Link& link, std::uint8_t channel) : link_(link), channel_(channel) { power_on(); }

  std::optional<std::vector<std::uint8_t>> control(const Setup& setup) override;
  Transfer out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes, Time now) override;
  Transfer in(std::uint8_t endpoint, std::size_t most, Time now) override;
  void clear_halt(std::uint8_t endpoint) override;
  std::optional<Time> wake() const override;
  void power_on() override;

  std::chrono::milliseconds latency() const { return latency_; }
  std::uint8_t bit_mode() const { return bit_mode_; }
  std::uint32_t divisor() const { return divisor_; }

 private:
  bool is_ours(std::uint8_t endpoint) const { return ((endpoint & 0x7FU) - 1U) / 2U == channel_; }
  /// Data with the status bytes of their packets.
  static std::vector<std::uint8_t> packets(std::span<const std::uint8_t> data);

  Link& link_;
  std::uint8_t channel_;
  std::vector<std::uint8_t> received_;  ///< from the core, for the host
  std::chrono::milliseconds latency_{};
  std::optional<Time> last_packet_;
  std::uint8_t bit_mode_ = 0;
  std::uint32_t divisor_ = 0;
};

}  // namespace cbvh::emulator
