// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace cbvh::vectors {

/// splitmix64: the same numbers with every compiler and library.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  /// 0 .. count - 1; count >= 1.
  constexpr std::uint64_t below(std::uint64_t count) { return next() % count; }
  /// low .. high, both included.
  constexpr int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  constexpr bool flip() { return (next() >> 63) != 0; }
  constexpr bool one_in(int count) { return below(static_cast<std::uint64_t>(count)) == 0; }
  /// A multiple of 2^-24 in [0, 1).
  constexpr float unit() { return static_cast<float>(next() >> 40) * 0x1p-24F; }

 private:
  std::uint64_t state_;
};

/// The seed of one case of a set: independent of the number of cases and of the shard.
constexpr std::uint64_t mix(std::uint64_t seed, std::uint64_t id) { return Random(Random(seed).next() + id).next(); }

}  // namespace cbvh::vectors
