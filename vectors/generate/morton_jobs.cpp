// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/morton_jobs.h"

#include <algorithm>
#include <limits>

#include "vectors/generate/floats.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSceneLike,
  kSignedZero,
  kSubnormal,
  kLargestFinite,
  kDegenerateAxis,
  kCellBorder,
  kOutside,
  kRandomBits,
  kRefused
};

struct Bounds {
  float lower;
  float upper;
};

Bounds in_order(float a, float b) { return {std::min(a, b), std::max(a, b)}; }

/// So many times the smallest float.
float of_last_places(int count) { return std::ldexp(static_cast<float>(count), -149); }

/// Few last places wide, so that the rounding of each operation is seen.
Bounds subnormal_scene(Random& random) {
  const int most = 1 << random.between(1, 14);
  return in_order(of_last_places(random.between(-most, most)), of_last_places(random.between(-most, most)));
}
Bounds subnormal_box(const Bounds& scene, Random& random) {
  const auto place = [&] {
    return of_last_places(
        random.between(static_cast<int>(std::ldexp(scene.lower, 149)), static_cast<int>(std::ldexp(scene.upper, 149))));
  };
  return in_order(place(), place());
}

Bounds scene_axis(std::size_t case_class, Random& random) {
  switch (case_class) {
    case kSignedZero:
      return random.flip() ? Bounds{any_zero(random), 1} : Bounds{-1, any_zero(random)};
    case kSubnormal:
      return random.one_in(3) ? in_order(any_tiny_float(random), any_tiny_float(random)) : subnormal_scene(random);
    case kLargestFinite:
      return random.one_in(4) ? Bounds{-std::numeric_limits<float>::max(), any_tiny_float(random)}
                              : Bounds{-std::fabs(any_huge_float(random)), std::fabs(any_huge_float(random))};
    case kRandomBits:
    case kOutside:
      return in_order(any_finite_float(random), any_finite_float(random));
    default: {
      const float size = std::ldexp(1.0F, random.between(-20, 20));
      return in_order(float_within(size, random), float_within(size, random));
    }
  }
}

/// A place in the scene: at a border between two of the 1024 cells, or a last place beside it.
Bounds at_cell_border(const Bounds& scene, Random& random) {
  const float border = static_cast<float>(random.below(1025)) / 1024;
  const float place = scene.lower + (scene.upper - scene.lower) * border;
  const float beside = std::nextafter(place, random.flip() ? scene.lower : scene.upper);
  return in_order(place, random.flip() ? place : beside);
}

Bounds box_axis(std::size_t case_class, const Bounds& scene, Random& random) {
  switch (case_class) {
    case kSignedZero:
      return random.one_in(3) ? Bounds{-random.unit(), random.unit()} : Bounds{any_zero(random), any_zero(random)};
    case kSubnormal:
      return subnormal_box(scene, random);
    case kLargestFinite:
      return random.flip() ? in_order(any_huge_float(random), any_huge_float(random))
                           : in_order(any_finite_float(random), any_finite_float(random));
    case kOutside:
    case kRandomBits:
      return in_order(any_finite_float(random), any_finite_float(random));
    case kCellBorder:
      return at_cell_border(scene, random);
    default: {
      const float extent = scene.upper - scene.lower;
      const float lower = scene.lower + extent * random.unit();
      return {lower, std::min(scene.upper, lower + extent * random.unit() / 64)};
    }
  }
}

}  // namespace

std::vector<MortonJob> make_morton_jobs(std::size_t case_class, Random& random) {
  std::array<Bounds, 3> scene{};
  for (Bounds& axis : scene) axis = scene_axis(case_class, random);
  if (case_class == kDegenerateAxis) {
    Bounds& flat = scene[random.below(3)];
    flat.upper = flat.lower;
  }
  MortonJob job;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.registers.scene.lower[axis] = rtl::Float32::of(scene[axis].lower);
    job.registers.scene.upper[axis] = rtl::Float32::of(scene[axis].upper);
  }
  std::vector<MortonJob> jobs;
  for (int left = random.between(1, 24); left-- > 0;) {
    job.box = {};
    job.box.id = rtl::Pointer::of_raw(random.next());
    job.box.last = rtl::UInt<1>(left == 0);
    if (case_class == kRefused && random.one_in(3)) {
      job.box.status = rtl::StatusBits(static_cast<std::uint64_t>(rtl::Status::not_finite));
    } else {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Bounds bounds = box_axis(case_class, scene[axis], random);
        job.box.box.lower[axis] = rtl::Float32::of(bounds.lower);
        job.box.box.upper[axis] = rtl::Float32::of(bounds.upper);
      }
    }
    jobs.push_back(job);
  }
  return jobs;
}

}  // namespace cbvh::vectors
