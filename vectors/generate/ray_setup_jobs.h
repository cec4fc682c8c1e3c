// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "rtl_model/datapath/ray_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 16> kRaySetupClasses = {
    "towards-box",    "axis-parallel",  "all-parallel", "backwards", "origin-in-face", "origin-inside",
    "degenerate-box", "tiny-direction", "huge-box",     "far-apart", "power-of-two",   "subnormal-offset",
    "infinite-edge",  "not-finite",     "inverted",     "any-wires"};
rtl::RaySetupJob make_ray_setup_job(std::size_t case_class, Random& random);

/// A ray at a box, of the classes up to infinite-edge: what a tree may meet.
inline constexpr std::size_t kValidRays = 13;

/// A ray of this class, one of kValidRays, at the box that `job` has.
void aim(std::size_t case_class, rtl::RaySetupJob& job, Random& random);

}  // namespace cbvh::vectors
