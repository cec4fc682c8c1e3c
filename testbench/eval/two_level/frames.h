// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/eval/two_level/measure.h"
#include "testbench/scene_of_frame.h"

namespace cbvh::testbench {

/// One top level of one frame: of a scene whose instances move it is built anew every frame (Bikker, part 6).
struct FrameMeasure {
  unsigned frame = 0;
  std::uint64_t references = 0;
  double build_seconds = 0;
  double sah = 0;  ///< as TopLevelMeasure has it
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;       ///< rays that hit something
  std::uint64_t box_tests = 0;  ///< on both levels
  std::uint64_t triangle_tests = 0;
  std::uint64_t transforms = 0;  ///< rays taken into the space of an instance
  std::uint64_t picture = 0;     ///< FNV-1a-64 over instance, triangle and distance of each pixel's nearest hit
  bool same_picture = true;      ///< as the first top level's over float trees, in the same frame
};

/// All frames of one top level.
struct FramesMeasure {
  std::string scene;
  std::string top;
  std::string trees;  ///< "float", or "compressed": the objects' and the top level's
  std::vector<FrameMeasure> frames;
};

struct PictureSize {
  unsigned width = 160;
  unsigned height = 120;
  unsigned threads = 1;
};

/// Builds every top level in every frame of every scene, in whose names {time} goes from 0 to 1. Throws InputError as
/// measure_two_level does, and for what does not move.
std::vector<FramesMeasure> measure_frames(const TwoLevelJob& job, unsigned frames, const PictureSize& size);

}  // namespace cbvh::testbench
