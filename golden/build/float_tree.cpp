// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/float_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Box triangle_box(const Mesh& mesh, std::size_t id) {
  const glm::uvec3 triangle = mesh.triangles[id];
  const auto place = [&] { return fmt::format("{}: triangle {}", mesh.name, id); };
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t vertex = triangle[corner];
    if (vertex >= mesh.positions.size()) {
      throw InputError(place(), fmt::format("vertex index {}, want below {}", vertex, mesh.positions.size()));
    }
    const glm::vec3& v = mesh.positions[vertex];
    if (!is_finite(v)) {
      throw InputError(place(),
                       fmt::format("vertex {} is ({}, {}, {}), want finite coordinates", vertex, v.x, v.y, v.z));
    }
  }
  const glm::vec3& a = mesh.positions[triangle.x];
  const glm::vec3& b = mesh.positions[triangle.y];
  const glm::vec3& c = mesh.positions[triangle.z];
  return {glm::min(glm::min(a, b), c) + 0.0F, glm::max(glm::max(a, b), c) + 0.0F};  // -0 + 0 is 0
}

}  // namespace

Box unite(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

float largest_magnitude(const Box& box) {
  const glm::vec3 m = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  return std::max({m.x, m.y, m.z});
}

std::vector<Box> triangle_boxes(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw InputError(mesh.name, "no triangles, want at least one");
  check_counts(mesh.name, mesh.triangles.size(), 0);
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t id = 0; id < mesh.triangles.size(); ++id) boxes.push_back(triangle_box(mesh, id));
  return boxes;
}

void check_counts(const std::string& place, std::uint64_t primitives, std::uint64_t pairs) {
  if (primitives > kMaxCount) throw InputError(place, fmt::format("{} primitives, want at most 2^27", primitives));
  if (pairs > kMaxCount) throw InputError(place, fmt::format("{} node pairs, want at most 2^27", pairs));
}

}  // namespace cbvh::golden
