// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/trace/camera.h"
#include "golden/trace/traverse.h"

namespace cbvh::testbench {

/// The nearest hit of each pixel, row after row from the top, and what they cost.
struct HitPicture {
  std::vector<golden::Hit> hits;
  golden::TraceCounts counts;
};

HitPicture trace_picture(const golden::FloatTree& tree, const golden::Mesh& mesh, const golden::Camera& camera,
                         unsigned width, unsigned height, unsigned threads);

/// FNV-1a-64 over triangles and distances: equal pictures have equal digests.
std::uint64_t digest(const HitPicture& picture);

}  // namespace cbvh::testbench
