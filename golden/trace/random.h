// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace cbvh::golden {

/// Random numbers that depend on a key and a counter alone: a ray gets the same ones whichever thread traces it, and
/// whichever tree. splitmix64, whose state is a counter; the key is where it starts.
class CounterRandom {
 public:
  /// One sequence for each pixel, sample of it, and bounce of the sample's path.
  CounterRandom(std::uint64_t pixel, std::uint64_t sample, std::uint64_t bounce)
      : counter_(mix(mix(mix(pixel + kStep) + sample + kStep) + bounce + kStep)) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double next() {
    counter_ += kStep;
    return static_cast<double>(mix(counter_) >> 11U) * 0x1p-53;
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;
  static constexpr std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
  }

  std::uint64_t counter_;
};

/// A direction of length 1, all alike. Square roots are its only functions, so it is the same bits everywhere.
glm::dvec3 any_direction(CounterRandom& random);

/// A direction of length 1 around a normal of length 1, denser in proportion to the cosine between them: light that a
/// diffuse surface reflects. The same bits everywhere, too.
glm::dvec3 diffuse_direction(const glm::dvec3& normal, CounterRandom& random);

}  // namespace cbvh::golden
