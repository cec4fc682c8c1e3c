// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

Mesh make(const OptionValues& options) {
  Random random(options.integer("seed"));
  const std::uint64_t count = options.integer("spheres");
  const std::uint64_t k = sphere_subdivision(options.integer("triangles"), count);
  Mesh mesh;
  for (std::uint64_t i = 0; i < count; ++i) {
    const glm::vec3 centre = random.in_cube(1.0f);
    const float u = random.unit();
    append_sphere(mesh, centre, 0.005f + 0.2f * u * u * u, k);  // many small, few large
  }
  return mesh;
}

}  // namespace

ProceduralScene spheres_scene() {
  return {"spheres",
          "spheres of all sizes that may overlap; spheres * 8 * k^2 triangles, k the greatest for which that is at "
          "most `triangles`, or 1",
          {triangles_option(100000, 8), {"spheres", "how many", 100, 1, 100000}, seed_option()},
          make};
}

}  // namespace cbvh::golden
