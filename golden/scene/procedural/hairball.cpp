// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

/// A ribbon of `segments` quads that starts at the origin's unit sphere and wanders outwards.
void append_strand(Mesh& mesh, std::uint64_t segments, float width, Random& random) {
  glm::vec3 heading = random.direction();
  glm::vec3 point = heading * 0.5f;
  const float step = 1.5f / static_cast<float>(segments);
  const std::uint64_t base = mesh.positions.size();
  for (std::uint64_t i = 0; i <= segments; ++i) {
    const glm::vec3 across = cross(heading, random.direction()) * width;
    mesh.positions.push_back(point - across);
    mesh.positions.push_back(point + across);
    heading = normalized(heading + random.in_cube(0.5f));
    point = point + heading * step;
  }
  for (std::uint64_t i = 0; i < segments; ++i)
    append_quad(mesh, base + 2 * i, base + 2 * i + 1, base + 2 * i + 3, base + 2 * i + 2);
}

Mesh make(const OptionValues& options) {
  Random random(options.integer("seed"));
  const std::uint64_t segments = options.integer("segments");
  const std::uint64_t strands = std::max<std::uint64_t>(1, options.integer("triangles") / (2 * segments));
  Mesh mesh;
  for (std::uint64_t i = 0; i < strands; ++i) append_strand(mesh, segments, options.real("width"), random);
  return mesh;
}

}  // namespace

ProceduralScene hairball_scene() {
  return {"hairball",
          "thin curled ribbons around a ball, whose boxes overlap badly; 2 * segments * max(1, floor(triangles / (2 * "
          "segments))) triangles",
          {triangles_option(100000, 2),
           {"segments", "quads along a strand", 25, 1, 1000},
           {"width", "half a strand's greatest width", 0.002, 0, 1, false},
           seed_option()},
          make};
}

}  // namespace cbvh::golden
