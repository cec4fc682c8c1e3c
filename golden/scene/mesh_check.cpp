// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/mesh_check.h"

#include <cmath>

namespace cbvh::golden {

void check_size(std::uint64_t triangles, std::uint64_t vertices, const std::string& place) {
  if (triangles > kMaxTriangles) {
    throw InputError(place, fmt::format("triangles: found {}, wanted at most 2^27 = {}", triangles, kMaxTriangles));
  }
  if (vertices > kMaxVertices) {
    throw InputError(place, fmt::format("vertices: found {}, wanted at most 3 * 2^27 = {}", vertices, kMaxVertices));
  }
}

std::string non_finite(const glm::vec3& position, std::uint64_t vertex) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(position[axis])) {
      return fmt::format("vertex {}: {} is {}, wanted a finite number", vertex, "xyz"[axis],
                         std::isnan(position[axis]) ? "NaN" : "infinite");
    }
  }
  return {};
}

void check_mesh(const Mesh& mesh, const std::string& place) {
  check_size(mesh.triangles.size(), mesh.positions.size(), place);
  if (mesh.triangles.empty()) throw InputError(place, "no triangles");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (const std::string fault = non_finite(mesh.positions[i], i); !fault.empty()) throw InputError(place, fault);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      if (const auto index = mesh.triangles[i][corner]; index >= mesh.positions.size()) {
        throw InputError(
            place, fmt::format("triangle {}: vertex index {}, wanted less than {}", i, index, mesh.positions.size()));
      }
    }
  }
}

}  // namespace cbvh::golden
