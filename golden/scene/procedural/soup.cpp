// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"

namespace cbvh::golden {
namespace {

Mesh make(const OptionValues& options) {
  Random random(options.integer("seed"));
  const float size = options.real("size");
  Mesh mesh;
  for (std::uint64_t i = 0; i < options.integer("triangles"); ++i) {
    const glm::vec3 centre = random.in_cube(1.0f);
    const std::uint64_t first = mesh.positions.size();
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(centre + random.in_cube(size));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

}  // namespace

ProceduralScene soup_scene() {
  return {"soup",
          "triangles strewn in a cube of side 2, no two connected; exactly `triangles`",
          {triangles_option(10000, 1),
           {"size", "half the greatest extent of a triangle", 0.05, 0, 1000, false},
           seed_option()},
          make};
}

}  // namespace cbvh::golden
