// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

namespace cbvh::rtl {

/// A binary32 as 32 wires. Two are equal when their bits are; the model never computes with the host's floating point
/// unit.
struct Float32 {
  static constexpr int kWidth = 32;
  std::uint32_t bits = 0;

  static constexpr Float32 of(float value) { return {std::bit_cast<std::uint32_t>(value)}; }
  constexpr float value() const { return std::bit_cast<float>(bits); }
  constexpr std::uint64_t raw() const { return bits; }
  static constexpr Float32 of_raw(std::uint64_t raw) { return {static_cast<std::uint32_t>(raw)}; }
  constexpr bool operator==(const Float32&) const = default;
};

}  // namespace cbvh::rtl
