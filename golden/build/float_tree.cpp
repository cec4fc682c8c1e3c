// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/float_tree.h"

#include <algorithm>
#include <glm/common.hpp>

#include "golden/build/triangle_box.h"
#include "golden/input_error.h"
#include "golden/scene/mesh_check.h"

namespace cbvh::golden {

Box unite(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

float largest_magnitude(const Box& box) {
  const glm::vec3 m = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  return std::max({m.x, m.y, m.z});
}

std::vector<Box> triangle_boxes(const Mesh& mesh) {
  check_mesh(mesh, mesh.name);
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    boxes.push_back(triangle_box(mesh.positions[triangle.x], mesh.positions[triangle.y], mesh.positions[triangle.z]));
  }
  return boxes;
}

double half_area(const Box& box) {
  const double x = static_cast<double>(box.upper.x) - static_cast<double>(box.lower.x);
  const double y = static_cast<double>(box.upper.y) - static_cast<double>(box.lower.y);
  const double z = static_cast<double>(box.upper.z) - static_cast<double>(box.lower.z);
  return x * y + y * z + z * x;
}

void check_counts(const std::string& place, std::uint64_t references, std::uint64_t pairs) {
  if (references > kMaxCount) throw InputError(place, fmt::format("{} primitives, want at most 2^27", references));
  if (pairs > kMaxCount) throw InputError(place, fmt::format("{} node pairs, want at most 2^27", pairs));
}

}  // namespace cbvh::golden
