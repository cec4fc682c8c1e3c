// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "golden/quantize/grid.h"
#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// An object placed in the world. Binary32, so that its products with coordinates are exact in binary64.
struct Instance {
  std::uint32_t object;      ///< index into the scene's objects
  glm::mat4 to_world{1.0F};  ///< affine: the bottom row is 0 0 0 1
};

/// Objects, each with a tree of its own, and where they stand (Bikker, part 6; Benthin et al., section 3.1).
struct TwoLevelScene {
  std::string name;
  std::vector<Mesh> objects;
  std::vector<Instance> instances;
};

/// Throws InputError at the scene's name, with the instance's or object's index, unless: every object keeps mesh.h's
/// promises; there are 1 to 2^27 instances, each of an object there is; every transform is finite, affine and
/// invertible; and everything stays within binary32 in the world.
void check_scene(const TwoLevelScene& scene);

bool is_identity(const glm::mat4& transform);

/// From the world to the object, in binary64. Throws InputError at `place` when the transform is not finite or not
/// affine, and when it is singular: its determinant cannot be told from zero in binary64.
glm::dmat4 inverse_of(const glm::mat4& to_world, const std::string& place);

/// A box around the image of a box: its sums in binary64 and their results in binary32 are rounded outwards. Of nested
/// boxes the images are nested; the identity changes nothing. Infinite where binary32 ends.
Box world_box(const Box& box, const glm::mat4& to_world);

/// A point's image as a float: within every world_box of a box that holds the point.
glm::vec3 world_point(const glm::vec3& point, const glm::mat4& to_world);

/// Triangles of all instances, instance after instance, each in its object's order. Throws InputError when they are
/// more than a mesh may have.
Mesh flatten(const TwoLevelScene& scene);

/// How many triangles all instances have together.
std::uint64_t instanced_triangles(const TwoLevelScene& scene);

}  // namespace cbvh::golden
