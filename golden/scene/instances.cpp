// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/instances.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <tuple>

#include "golden/scene/directed.h"
#include "golden/scene/mesh_check.h"

namespace cbvh::golden {
namespace {

constexpr glm::length_t kAxes = 3;

void check_affine(const glm::mat4& to_world, const std::string& place) {
  for (glm::length_t row = 0; row < 4; ++row) {
    for (glm::length_t column = 0; column < 4; ++column) {
      const float found = to_world[column][row];
      if (!std::isfinite(found))
        throw InputError(
            place, fmt::format("transform, row {}, column {}: found {}, wanted a finite number", row, column, found));
      const float wanted = column == 3 ? 1 : 0;
      if (row == 3 && found != wanted)
        throw InputError(place, fmt::format("transform, row 3, column {}: found {}, wanted {}", column, found, wanted));
    }
  }
}

/// The entry of the 3 x 3 part's adjugate for column c of row r: the minor without row c and column r, with its sign.
double adjugate(const glm::mat4& m, glm::length_t r, glm::length_t c) {
  const glm::length_t r1 = (c + 1) % kAxes;
  const glm::length_t r2 = (c + 2) % kAxes;
  const glm::length_t c1 = (r + 1) % kAxes;
  const glm::length_t c2 = (r + 2) % kAxes;
  return static_cast<double>(m[c1][r1]) * static_cast<double>(m[c2][r2]) -
         static_cast<double>(m[c1][r2]) * static_cast<double>(m[c2][r1]);
}

/// The box of an object's vertices.
Box object_box(const Mesh& mesh) {
  Box box{mesh.positions[0], mesh.positions[0]};
  for (const glm::vec3& position : mesh.positions) box = {glm::min(box.lower, position), glm::max(box.upper, position)};
  return box;
}

bool is_finite(const Box& box) {
  for (glm::length_t axis = 0; axis < kAxes; ++axis) {
    if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis])) return false;
  }
  return true;
}

}  // namespace

bool is_identity(const glm::mat4& transform) { return transform == glm::mat4(1.0F); }

glm::dmat4 inverse_of(const glm::mat4& to_world, const std::string& place) {
  check_affine(to_world, place);
  double determinant = 0;
  double magnitude = 0;
  for (glm::length_t k = 0; k < kAxes; ++k) {
    for (const glm::length_t sign : {1, 2}) {  // one column forwards, or one backwards, from row to row
      const double product = static_cast<double>(to_world[k][0]) *
                             static_cast<double>(to_world[(k + sign) % kAxes][1]) *
                             static_cast<double>(to_world[(k + 2 * sign) % kAxes][2]);
      determinant += sign == 1 ? product : -product;
      magnitude += std::abs(product);
    }
  }
  // Each product is rounded once and each of five additions once: the error is below 6 * 2^-53 of the magnitude.
  if (!(std::abs(determinant) > magnitude * 0x1p-50))
    throw InputError(place, fmt::format("transform: found one that is singular (determinant {}), wanted one that has "
                                        "an inverse",
                                        determinant));
  glm::dmat4 inverse(1.0);
  for (glm::length_t r = 0; r < kAxes; ++r) {
    for (glm::length_t c = 0; c < kAxes; ++c) inverse[c][r] = adjugate(to_world, r, c) / determinant;
  }
  for (glm::length_t r = 0; r < kAxes; ++r) {
    for (glm::length_t c = 0; c < kAxes; ++c) inverse[3][r] -= inverse[c][r] * static_cast<double>(to_world[3][c]);
    for (glm::length_t c = 0; c < 4; ++c) {
      if (!std::isfinite(inverse[c][r]))
        throw InputError(place, "transform: its inverse does not fit binary64, wanted one that does");
    }
  }
  return inverse;
}

Box world_box(const Box& box, const glm::mat4& to_world) {
  struct Image {
    float lower;
    float upper;
  };
  const auto image = [&box](float x, float y, float z, float translation) -> Image {
    Double2 bounds{translation, -translation};  // the upper one negated: both are rounded down
    const auto add = [&bounds](double factor, double lower, double upper) {
      const double a = factor * lower;
      const double b = factor * upper;
      bounds = add_down(bounds, Double2{std::min(a, b), -std::max(a, b)});
    };
    add(x, box.lower.x, box.upper.x);
    add(y, box.lower.y, box.upper.y);
    add(z, box.lower.z, box.upper.z);
    const auto [lower, negated_upper] = floats_down(bounds);
    return {lower, 0.0F - negated_upper};
  };
  const auto& [cx, cy, cz, translation] = std::tie(to_world[0], to_world[1], to_world[2], to_world[3]);
  const Image x = image(cx.x, cy.x, cz.x, translation.x);
  const Image y = image(cx.y, cy.y, cz.y, translation.y);
  const Image z = image(cx.z, cy.z, cz.z, translation.z);
  return {{x.lower, y.lower, z.lower}, {x.upper, y.upper, z.upper}};
}

glm::vec3 world_point(const glm::vec3& point, const glm::mat4& to_world) {
  const Box around = world_box({point, point}, to_world);
  glm::vec3 world;
  for (glm::length_t row = 0; row < kAxes; ++row) {
    auto sum = static_cast<double>(to_world[3][row]);
    for (glm::length_t column = 0; column < kAxes; ++column)
      sum += static_cast<double>(to_world[column][row]) * static_cast<double>(point[column]);
    world[row] = std::clamp(static_cast<float>(sum), around.lower[row], around.upper[row]) + 0.0F;
  }
  return world;
}

void check_scene(const TwoLevelScene& scene) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    check_mesh(scene.objects[i], fmt::format("{}: object {}", scene.name, i));
    boxes.push_back(object_box(scene.objects[i]));
  }
  if (scene.instances.empty()) throw InputError(scene.name, "found no instances, wanted at least 1");
  if (scene.instances.size() > kMaxTriangles)
    throw InputError(scene.name, fmt::format("found {} instances, wanted at most 2^27", scene.instances.size()));
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const std::string place = fmt::format("{}: instance {}", scene.name, i);
    if (instance.object >= boxes.size())
      throw InputError(place,
                       fmt::format("found object {}, wanted one of the {} there are", instance.object, boxes.size()));
    inverse_of(instance.to_world, place);
    if (!is_finite(world_box(boxes[instance.object], instance.to_world)))
      throw InputError(place, "found coordinates beyond binary32 in the world, wanted finite ones");
  }
}

std::uint64_t instanced_triangles(const TwoLevelScene& scene) {
  std::uint64_t triangles = 0;
  for (const Instance& instance : scene.instances) triangles += scene.objects[instance.object].triangles.size();
  return triangles;
}

Mesh flatten(const TwoLevelScene& scene) {
  std::uint64_t vertices = 0;
  for (const Instance& instance : scene.instances) vertices += scene.objects[instance.object].positions.size();
  check_size(instanced_triangles(scene), vertices, scene.name);
  Mesh mesh;
  mesh.name = scene.name;
  mesh.positions.reserve(vertices);
  mesh.triangles.reserve(instanced_triangles(scene));
  for (const Instance& instance : scene.instances) {
    const Mesh& object = scene.objects[instance.object];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& position : object.positions)
      mesh.positions.push_back(world_point(position, instance.to_world));
    for (const glm::uvec3& triangle : object.triangles) mesh.triangles.push_back(triangle + first);
  }
  return mesh;
}

}  // namespace cbvh::golden
