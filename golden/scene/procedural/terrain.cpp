// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

/// Smooth noise in [0, 1): random values on the integer lattice, joined by the cubic 3t^2 - 2t^3.
class LatticeNoise {
 public:
  explicit LatticeNoise(std::uint64_t seed_value) : seed(seed_value) {}

  float operator()(float x, float y) const {
    const auto i = static_cast<std::uint64_t>(x);
    const auto j = static_cast<std::uint64_t>(y);
    const float s = smooth(x - static_cast<float>(i));
    const float t = smooth(y - static_cast<float>(j));
    const float low = mix(at(i, j), at(i + 1, j), s);
    const float high = mix(at(i, j + 1), at(i + 1, j + 1), s);
    return mix(low, high, t);
  }

 private:
  static float smooth(float t) { return t * t * (3.0f - 2.0f * t); }
  static float mix(float a, float b, float t) { return a + (b - a) * t; }
  float at(std::uint64_t i, std::uint64_t j) const { return Random(Random::mixed(seed + (i << 32)) + j).unit(); }

  std::uint64_t seed;
};

Mesh make(const OptionValues& options) {
  constexpr int kOctaves = 8;
  const LatticeNoise noise(options.integer("seed"));
  std::uint64_t n = 1;
  while (2 * (n + 1) * (n + 1) <= options.integer("triangles")) ++n;
  Mesh mesh;
  for (std::uint64_t i = 0; i <= n; ++i) {
    for (std::uint64_t j = 0; j <= n; ++j) {
      const float x = static_cast<float>(i) / static_cast<float>(n);
      const float y = static_cast<float>(j) / static_cast<float>(n);
      float height = 0.0f;
      float frequency = 3.0f;
      float amplitude = options.real("height") * 0.5f;
      for (int octave = 0; octave < kOctaves; ++octave) {
        // Octaves are shifted apart: nothing special happens at the origin.
        height = height + amplitude * noise(x * frequency + static_cast<float>(16 * octave), y * frequency);
        frequency = frequency * 2.0f;
        amplitude = amplitude * 0.5f;
      }
      mesh.positions.emplace_back(-1.0f + 2.0f * x, -1.0f + 2.0f * y, height);
    }
  }
  const auto vertex = [&](std::uint64_t i, std::uint64_t j) { return i * (n + 1) + j; };
  for (std::uint64_t i = 0; i < n; ++i) {
    for (std::uint64_t j = 0; j < n; ++j)
      append_quad(mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  }
  return mesh;
}

}  // namespace

ProceduralScene terrain_scene() {
  return {
      "terrain",
      "a fractal height field; 2 * n^2 triangles, n the greatest for which that is at most `triangles`",
      {triangles_option(100000, 2), {"height", "greatest height; the side is 2", 0.5, 0, 1000, false}, seed_option()},
      make};
}

}  // namespace cbvh::golden
