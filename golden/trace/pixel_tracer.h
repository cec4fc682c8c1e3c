// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "golden/trace/camera.h"
#include "golden/trace/random.h"
#include "golden/trace/surface.h"
#include "golden/trace/traced_mesh.h"

namespace cbvh::golden {

/// What a pixel's samples are. Every pixel has one primary ray; the secondary ones start where it hits.
enum class RayKind : std::uint8_t {
  primary,    ///< none
  occlusion,  ///< a ray into the hemisphere, any hit, a quarter of the scene's diagonal long
  path,       ///< a path of up to kMostBounces rays, each in a diffuse direction, until one leaves the scene
};

inline constexpr unsigned kMostBounces = 8;

/// Rays and what they cost.
struct RayCounts {
  std::uint64_t rays = 0;
  TraceCounts tests;
  void add(const RayCounts& other) {
    rays += other.rays;
    tests.add(other.tests);
  }
  bool operator==(const RayCounts&) const = default;
};

/// What a pixel sees.
template <class Hit>
struct Pixel {
  Hit hit;               ///< of the primary ray
  glm::dvec3 normal{0};  ///< of length 1, towards the viewer; zeros where nothing is hit, or a triangle without area
  double light = 0;      ///< 0..1: the cosine between ray and normal, or the samples' mean; 0 where nothing is hit
  RayCounts primary;
  RayCounts secondary;
};

/// Traces pixels of what lies behind one tree: of a TracedMesh, or of TracedInstances (two_level/traced_instances.h);
/// one a thread. Everything but the tests is the same for every tree of the scene.
template <class Traced>
class PixelTracer {
 public:
  using Hit = typename Traced::Hit;

  PixelTracer(Traced traced, const Camera& camera, RayKind kind, unsigned samples)
      : traced_(std::move(traced)),
        camera_(camera),
        kind_(kind),
        samples_(samples),
        scale_(scene_scale(traced_.box())) {}

  /// Pixel (0, 0) is the upper left one.
  Pixel<Hit> trace(unsigned x, unsigned y, unsigned width, unsigned height) {
    Pixel<Hit> pixel;
    const Ray ray = camera_.ray(x, y, width, height);
    pixel.hit = counted(ray, Stop::closest, pixel.primary);
    const std::optional<Surface> surface = traced_.surface(ray, pixel.hit);
    if (!surface) return pixel;
    pixel.normal = surface->normal;
    if (kind_ == RayKind::primary) {
      pixel.light = facing(*surface, ray);
      return pixel;
    }
    double sum = 0;
    for (unsigned sample = 0; sample < samples_; ++sample) {
      const std::uint64_t number = std::uint64_t{y} * width + x;
      sum += kind_ == RayKind::occlusion ? occlusion(*surface, number, sample, pixel.secondary)
                                         : path(*surface, number, sample, pixel.secondary);
    }
    pixel.light = sum / samples_;
    return pixel;
  }

 private:
  double occlusion(const Surface& surface, std::uint64_t pixel, unsigned sample, RayCounts& counts) {
    CounterRandom random(pixel, sample, 0);
    Ray ray = leaving(surface, diffuse_direction(surface.normal, random), scale_);
    ray.t_max = static_cast<float>(scale_.diagonal * 0.25);
    return can_leave(ray) && counted(ray, Stop::any, counts) == Hit() ? 1 : 0;
  }

  double path(Surface surface, std::uint64_t pixel, unsigned sample, RayCounts& counts) {
    double reflected = kAlbedo;
    for (unsigned bounce = 0; bounce < kMostBounces; ++bounce) {
      CounterRandom random(pixel, sample, bounce);
      const glm::dvec3 direction = diffuse_direction(surface.normal, random);
      const Ray ray = leaving(surface, direction, scale_);
      if (!can_leave(ray)) return 0;
      const Hit hit = counted(ray, Stop::closest, counts);
      if (hit == Hit()) return reflected * sky(direction);
      const std::optional<Surface> next = traced_.surface(ray, hit);
      if (!next) return 0;
      surface = *next;
      reflected *= kAlbedo;
    }
    return 0;
  }

  Hit counted(const Ray& ray, Stop stop, RayCounts& counts) {
    const TraceCounts before = traced_.counts();
    const Hit hit = traced_.trace(ray, stop);
    ++counts.rays;
    const TraceCounts after = traced_.counts();
    counts.tests.add(
        {after.pairs - before.pairs, after.box_tests - before.box_tests, after.triangle_tests - before.triangle_tests});
    return hit;
  }

  Traced traced_;
  Camera camera_;
  RayKind kind_;
  unsigned samples_;
  SceneScale scale_;
};

}  // namespace cbvh::golden
