// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace cbvh::golden {

/// splitmix64 (Steele, Lea, Flood 2014). Ours rather than <random>'s distributions, which differ between standard
/// libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state(seed) {}

  std::uint64_t bits() {
    state += 0x9e3779b97f4a7c15;
    return mixed(state);
  }

  /// In [0, 1), a multiple of 2^-24.
  float unit() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }

  float between(float least, float greatest) { return least + (greatest - least) * unit(); }

  glm::vec3 in_cube(float half) {
    const float x = between(-half, half);
    const float y = between(-half, half);
    const float z = between(-half, half);
    return {x, y, z};
  }

  /// A direction of length one, up to rounding. By rejection, without trigonometry.
  glm::vec3 direction();

  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state;
};

}  // namespace cbvh::golden
