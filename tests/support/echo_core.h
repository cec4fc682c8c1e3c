// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "fpga/emulator/core.h"

namespace cbvh::testing {

/// The inside of a board that says what it hears.
class EchoCore final : public emulator::Core {
 public:
  void receive(std::span<const std::uint8_t> bytes) override {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::uint8_t> send(std::size_t most) override {
    const auto cut = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(most, bytes_.size()));
    std::vector<std::uint8_t> bytes(bytes_.begin(), cut);
    bytes_.erase(bytes_.begin(), cut);
    return bytes;
  }
  void reset() override { bytes_.clear(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace cbvh::testing
