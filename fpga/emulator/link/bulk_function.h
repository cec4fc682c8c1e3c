// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fpga/emulator/link/function.h"

namespace cbvh::emulator {

/// Two bulk endpoints that carry the link's bytes as they are.
class BulkFunction final : public Function {
 public:
  static constexpr std::uint8_t kOut = 0x01;
  static constexpr std::uint8_t kIn = 0x81;

  explicit BulkFunction(Link& link) : link_(link) {}

  std::optional<std::vector<std::uint8_t>> control(const Setup&) override { return std::nullopt; }
  Transfer out(std::uint8_t, std::span<const std::uint8_t> bytes, Time now) override { return link_.out(bytes, now); }
  Transfer in(std::uint8_t, std::size_t most, Time now) override { return link_.in(most, now); }
  void clear_halt(std::uint8_t endpoint) override {
    link_.clear_halt((endpoint & 0x80U) != 0 ? Direction::in : Direction::out);
  }
  std::optional<Time> wake() const override { return link_.wake(); }
  void power_on() override {}

 private:
  Link& link_;
};

}  // namespace cbvh::emulator
