// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "golden/scene/procedural/procedural.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/procedural/shapes.h"

namespace cbvh::golden {
namespace {

struct Fragment {
  glm::vec3 centre;  ///< on the sphere; also where it flies
  float speed;
  glm::vec3 spin;  ///< axis times rate
};

std::vector<Fragment> make_fragments(std::uint64_t count, Random& random) {
  std::vector<Fragment> fragments(count);
  for (Fragment& fragment : fragments) {
    fragment.centre = random.direction();
    fragment.speed = random.between(0.5f, 2.0f);
    const glm::vec3 axis = random.direction();
    fragment.spin = axis * random.between(0.0f, 3.0f);
  }
  return fragments;
}

const Fragment& nearest(const std::vector<Fragment>& fragments, const glm::vec3& point) {
  const Fragment* best = &fragments.front();
  for (const Fragment& fragment : fragments) {
    if (dot(fragment.centre, point) > dot(best->centre, point)) best = &fragment;
  }
  return *best;
}

/// How far `v` moves when turned by the quaternion (1, r) brought to length one: 2 (r x (v + r x v)) / (1 + r.r). No
/// trigonometry.
glm::vec3 turned_by(const glm::vec3& v, const glm::vec3& r) {
  const glm::vec3 swing = cross(r, v);
  return (swing + cross(r, swing)) * (2.0f / (1.0f + dot(r, r)));
}

Mesh make(const OptionValues& options) {
  Random random(options.integer("seed"));
  const float time = options.real("time");
  Mesh sphere;
  append_sphere(sphere, glm::vec3(0.0f), 1.0f, sphere_subdivision(options.integer("triangles"), 1));
  const std::vector<Fragment> fragments = make_fragments(options.integer("fragments"), random);

  Mesh mesh;
  mesh.positions.reserve(3 * sphere.triangles.size());
  mesh.triangles.reserve(sphere.triangles.size());
  for (const glm::uvec3& triangle : sphere.triangles) {
    const glm::vec3 corners[3] = {sphere.positions[triangle.x], sphere.positions[triangle.y],
                                  sphere.positions[triangle.z]};
    const Fragment& fragment = nearest(fragments, corners[0] + corners[1] + corners[2]);
    const glm::vec3 flight = fragment.centre * fragment.speed * time;
    const std::uint64_t first = mesh.positions.size();
    for (const glm::vec3& p : corners)
      mesh.positions.push_back(p + (flight + turned_by(p - fragment.centre, fragment.spin * time)));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

}  // namespace

ProceduralScene explode_scene() {
  return {"explode",
          "a sphere that bursts into spinning fragments, for refitting: triangles keep their order over `time`, at 0 "
          "the sphere is whole; "
          "8 * k^2 triangles, k the greatest for which that is at most `triangles`",
          {triangles_option(100000, 8),
           {"fragments", "how many", 64, 1, 256},
           {"time", "since the explosion", 0, 0, 1000, false},
           seed_option()},
          make};
}

}  // namespace cbvh::golden
