// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/hits/ray_sets.h"

#include <glm/geometric.hpp>

#include "golden/trace/random.h"

namespace cbvh::testbench {

namespace {

class RayMaker {
 public:
  RayMaker(const golden::Mesh& mesh, const golden::Box& box, golden::CounterRandom random)
      : mesh_(mesh), lower_(box.lower), extent_(glm::dvec3(box.upper) - glm::dvec3(box.lower)), random_(random) {}

  golden::Ray incoherent() {
    while (true) {
      const glm::dvec3 direction(two_sided(), two_sided(), two_sided());
      const double square = glm::dot(direction, direction);
      if (square <= 1 && square > 1e-6) return {place(0.25), glm::vec3(direction)};
    }
  }

  golden::Ray axis_parallel() {
    const auto axis = static_cast<glm::length_t>(below(3));
    golden::Ray ray{below(2) == 0 ? place(0) : vertex(), glm::vec3(0)};
    for (glm::length_t other = 0; other < 3; ++other) ray.direction[other] = below(2) == 0 ? 0.0F : -0.0F;
    ray.direction[axis] = below(2) == 0 ? 1.0F : -1.0F;
    if (below(4) > 0) ray.origin[axis] = place(1)[axis];
    return ray;
  }

  golden::Ray at_an_edge() {
    const glm::uvec3& triangle = this->triangle();
    const auto side = static_cast<glm::length_t>(below(3));
    const glm::dvec3 from(mesh_.positions[triangle[side]]);
    const glm::dvec3 to(mesh_.positions[triangle[(side + 1) % 3]]);
    return towards(glm::vec3(from + (to - from) * (below(4) == 0 ? 0.5 : random_.next())));
  }

  golden::Ray at_a_vertex() { return towards(vertex()); }

 private:
  double two_sided() { return 2 * random_.next() - 1; }
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(random_.next() * static_cast<double>(count));
  }
  const glm::uvec3& triangle() { return mesh_.triangles[below(mesh_.triangles.size())]; }
  glm::vec3 vertex() { return mesh_.positions[triangle()[static_cast<glm::length_t>(below(3))]]; }

  /// In the box, or around it by that part of its size.
  glm::vec3 place(double around) {
    const auto part = [&] { return random_.next() * (1 + 2 * around) - around; };
    const double x = part();
    const double y = part();
    return glm::vec3(lower_ + extent_ * glm::dvec3(x, y, part()));
  }

  golden::Ray towards(const glm::vec3& target) {
    golden::Ray ray{place(0.5), glm::vec3(0)};
    ray.direction = target - ray.origin;
    if (ray.direction == glm::vec3(0)) ray.direction.x = 1;
    return ray;
  }

  const golden::Mesh& mesh_;
  glm::dvec3 lower_;
  glm::dvec3 extent_;
  golden::CounterRandom random_;
};

}  // namespace

golden::Ray made_ray(RaySet set, const golden::Mesh& mesh, const golden::Box& box, std::uint64_t seed,
                     std::uint64_t number) {
  RayMaker maker(mesh, box, golden::CounterRandom(number, seed, static_cast<std::uint64_t>(set)));
  switch (set) {
    case RaySet::incoherent:
      return maker.incoherent();
    case RaySet::axis_parallel:
      return maker.axis_parallel();
    case RaySet::edges:
      return maker.at_an_edge();
    case RaySet::vertices:
      break;
  }
  return maker.at_a_vertex();
}

}  // namespace cbvh::testbench
