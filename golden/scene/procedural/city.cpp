// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

void append_box(Mesh& mesh, const glm::vec3& low, const glm::vec3& high) {
  const std::uint64_t base = mesh.positions.size();
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                (corner & 4) != 0 ? high.z : low.z);
  }
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    const auto vertex = [&](int i) { return base + static_cast<std::uint64_t>(f[i]); };
    append_quad(mesh, vertex(0), vertex(1), vertex(2), vertex(3));
  }
}

Mesh make(const OptionValues& options) {
  Random random(options.integer("seed"));
  const std::uint64_t boxes = (options.integer("triangles") - 2) / 12;
  std::uint64_t side = 1;
  while (side * side < boxes) ++side;
  Mesh mesh;
  // The ground first: one quad as large as everything else together.
  const float edge = static_cast<float>(side) * 20.0f;
  for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {edge, 0.0f}, {edge, edge}, {0.0f, edge}})
    mesh.positions.emplace_back(x, y, 0.0f);
  append_quad(mesh, 0, 1, 2, 3);
  for (std::uint64_t i = 0; i < boxes; ++i) {
    const std::uint64_t row = i / side;
    const std::uint64_t column = i % side;
    const float x = static_cast<float>(column) * 20.0f;
    const float y = static_cast<float>(row) * 20.0f;
    const float west = x + random.between(1.0f, 6.0f);
    const float south = y + random.between(1.0f, 6.0f);
    const float east = x + random.between(12.0f, 19.0f);
    const float north = y + random.between(12.0f, 19.0f);
    const float u = random.unit();
    append_box(mesh, {west, south, 0.0f}, {east, north, 3.0f + 300.0f * u * u * u * u});  // few towers
  }
  return mesh;
}

}  // namespace

ProceduralScene city_scene() {
  return {"city",
          "axis-parallel boxes, large triangles, on one ground quad; 2 + 12 * floor((triangles - 2) / 12) triangles",
          {triangles_option(100000, 14), seed_option()},
          make};
}

}  // namespace cbvh::golden
