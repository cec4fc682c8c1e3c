// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

/// (n + 1)^2 vertices at(i, j), i the outer loop, and n^2 quads between them.
template <class At>
void append_grid(Mesh& mesh, std::uint64_t n, const At& at) {
  const std::uint64_t base = mesh.positions.size();
  for (std::uint64_t i = 0; i <= n; ++i) {
    for (std::uint64_t j = 0; j <= n; ++j) mesh.positions.push_back(at(static_cast<float>(i), static_cast<float>(j)));
  }
  const auto vertex = [&](std::uint64_t i, std::uint64_t j) { return base + i * (n + 1) + j; };
  for (std::uint64_t i = 0; i < n; ++i) {
    for (std::uint64_t j = 0; j < n; ++j)
      append_quad(mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  }
}

/// DESIGN section 3.2, to the letter: reference digests depend on each operation and its order.
Mesh make(const OptionValues& options) {
  Mesh mesh;
  const std::uint64_t sheet = options.integer("sheet");
  const auto m = static_cast<float>(sheet);
  append_grid(mesh, sheet,
              [&](float i, float j) { return glm::vec3(-1.0f + 2.0f * i / m, -1.0f + 2.0f * j / m, -0.4f); });
  const std::uint64_t height = options.integer("height");
  const auto n = static_cast<float>(height);
  append_grid(mesh, height, [&](float i, float j) {
    const float x = -0.8f + 1.6f * i / n;
    const float y = -0.8f + 1.6f * j / n;
    return glm::vec3(x, y, 0.1f + 0.25f * (1.0f - x * x) * (1.0f - y * y));
  });
  return mesh;
}

}  // namespace

ProceduralScene cloth_scene() {
  return {"cloth",
          "a sheet below a height field, the scene of the reference results; 2 * sheet^2 + 2 * height^2 triangles, "
          "nothing random",
          {{"sheet", "quads along a side of the sheet", 150, 1, 1024},
           {"height", "quads along a side of the height field", 100, 1, 1024}},
          make};
}

}  // namespace cbvh::golden
