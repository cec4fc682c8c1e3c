// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "testbench/trace/picture.h"

namespace cbvh::testbench {

/// The N whose trees are traced.
inline constexpr std::array<int, 5> kTracedBits = {4, 5, 6, 7, 8};

struct RaysJob {
  std::vector<std::string> scenes;
  std::string builder = "lbvh";
  golden::Code code = golden::Code::modulo;
  PictureJob picture{.samples = 1, .width = 256, .height = 192};  ///< its rays are set by measure_rays
};

/// Rays of one kind in one scene: those of the kind alone, so secondary ones without the primary ones before them.
struct RaysMeasure {
  std::string scene;
  std::string rays;  ///< "primary", "ambient-occlusion" or "path"
  golden::RayCounts floats;
  std::array<golden::RayCounts, kTracedBits.size()> compressed;  ///< by kTracedBits
};

struct RaysMeasurement {
  std::vector<RaysMeasure> measures;  ///< scene by scene
  std::uint64_t checks = 0;           ///< pixels
  std::vector<std::string> failures;
};

/// Throws InputError for a scene or builder that is none, and as check_picture_job does, before anything is traced.
RaysMeasurement measure_rays(const RaysJob& job);

}  // namespace cbvh::testbench
