// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

constexpr std::size_t kShapes = 4;
using Centres = std::array<glm::vec3, kShapes>;  ///< of a triangle in each shape

/// Places of a shape that triangles take: their own, or for a share of them those of each other.
std::vector<std::uint32_t> places(std::size_t count, float mix, Random& random) {
  std::vector<std::uint32_t> movers;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (random.unit() < mix) movers.push_back(i);
  }
  std::vector<std::uint32_t> taken(count);
  std::iota(taken.begin(), taken.end(), 0U);
  std::vector<std::uint32_t> shuffled = movers;
  for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.bits() % i]);
  for (std::size_t i = 0; i < movers.size(); ++i) taken[movers[i]] = shuffled[i];
  return taken;
}

/// A place of a square sheet, row after row.
glm::vec3 on_sheet(std::uint32_t place, std::size_t count) {
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<float>(count))));
  const auto at = [side](std::uint32_t step) {
    return (static_cast<float>(step) + 0.5f) / static_cast<float>(side) * 2.0f - 1.0f;
  };
  return {at(place % side), 0.0f, at(place / side)};
}

/// Sphere, sheet, cloud, a smaller sphere.
std::vector<Centres> make_centres(const std::vector<glm::vec3>& sphere, float mix, Random& random) {
  const std::size_t count = sphere.size();
  std::vector<Centres> centres(count);
  const std::vector<std::uint32_t> sheet = places(count, mix, random);
  for (std::size_t i = 0; i < count; ++i) {
    centres[i][0] = sphere[i];
    centres[i][1] = on_sheet(sheet[i], count);
    const glm::vec3 away = random.in_cube(1.0f);
    centres[i][2] = sphere[i] + (away - sphere[i]) * mix;
  }
  const std::vector<std::uint32_t> last = places(count, mix, random);
  for (std::size_t i = 0; i < count; ++i) centres[i][3] = sphere[last[i]] * 0.5f;
  return centres;
}

Mesh make(const OptionValues& options) {
  Random random(options.integer("seed"));
  const float phase = options.real("time") * static_cast<float>(kShapes - 1);
  const auto shape = std::min(static_cast<std::size_t>(phase), kShapes - 2);
  const float part = phase - static_cast<float>(shape);
  Mesh sphere;
  append_sphere(sphere, glm::vec3(0.0f), 1.0f, sphere_subdivision(options.integer("triangles"), 1));
  std::vector<glm::vec3> middles;
  middles.reserve(sphere.triangles.size());
  for (const glm::uvec3& t : sphere.triangles)
    middles.push_back((sphere.positions[t.x] + sphere.positions[t.y] + sphere.positions[t.z]) / 3.0f);
  const std::vector<Centres> centres = make_centres(middles, options.real("mix"), random);

  Mesh mesh;
  mesh.positions.reserve(3 * sphere.triangles.size());
  mesh.triangles.reserve(sphere.triangles.size());
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
    const glm::vec3& from = centres[i][shape];
    const glm::vec3 centre = from + (centres[i][shape + 1] - from) * part;
    const std::uint64_t first = mesh.positions.size();
    for (int corner = 0; corner < 3; ++corner)
      mesh.positions.push_back(centre + (sphere.positions[sphere.triangles[i][corner]] - middles[i]));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

}  // namespace

ProceduralScene morph_scene() {
  return {"morph",
          "a sphere whose triangles become a sheet, a cloud and a smaller sphere, for refitting: they keep their order "
          "over `time`, in which each flies straight from shape to shape; "
          "8 * k^2 triangles, k the greatest for which that is at most `triangles`",
          {triangles_option(100000, 8),
           {"mix", "share of the triangles that change places with each other on the way", 0.5, 0, 1, false},
           {"time", "0 the sphere, 1/3 the sheet, 2/3 the cloud, 1 the smaller sphere", 0, 0, 1, false},
           seed_option()},
          make};
}

}  // namespace cbvh::golden
