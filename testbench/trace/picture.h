// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "testbench/progress.h"
#include "testbench/trace/pixel_source.h"

namespace cbvh::testbench {

struct PictureJob {
  std::string camera = "around";
  golden::RayKind rays = golden::RayKind::primary;
  unsigned samples = 4;  ///< a pixel, of secondary rays
  unsigned width = 512;
  unsigned height = 384;
  unsigned threads = 0;  ///< 0: one a core
};

/// One of the trees that a picture is traced through.
struct PictureTree {
  std::string name;
  std::function<std::unique_ptr<PixelSource>(const Shot&)> pixels;  ///< called once a row, by any thread
};

/// What a picture cost through one tree, and how it compares with the first tree's.
struct TreeCost {
  std::string name;
  golden::RayCounts primary;
  golden::RayCounts secondary;
  double seconds = 0;  ///< of all threads together
  std::uint64_t different_pixels = 0;
  double rays_per_second() const { return static_cast<double>(primary.rays + secondary.rays) / seconds; }
};

/// What is drawn of a pixel.
struct PixelFigures {
  std::uint32_t box_tests;
  std::uint32_t triangle_tests;
  std::uint8_t light;                  ///< 0..255
  std::array<std::uint8_t, 3> normal;  ///< -1..1 as 0..255
  bool hit;
  bool different;  ///< not the same through all trees
};

struct TracedPicture {
  unsigned width;
  unsigned height;
  std::vector<PixelFigures> pixels;  ///< as the tree that is shown sees them
  std::vector<TreeCost> trees;
  std::uint64_t hits = 0;
  std::uint64_t different_pixels = 0;  ///< that some tree sees otherwise than the first one
  std::string first_difference;        ///< of them, in words
};

/// Throws InputError for a size of zero or beyond 2^25 pixels, and for threads and samples out of their range.
void check_picture_job(const PictureJob& job);

/// "around", "inside", or "EX,EY,EZ:TX,TY,TZ[:H]", eye, target and half the image's height at distance 1. Throws
/// InputError, also when the rays of the image's corners are none.
golden::Camera camera_of(const PictureJob& job, const golden::Box& box);

/// Traces every pixel through every tree, row by row in turn, and compares hit, distance, normal and light bit for bit
/// with the first tree's. `box`: the scene's. `shown`: the index of the tree whose figures the picture gets.
TracedPicture trace_trees(const std::vector<PictureTree>& trees, const golden::Box& box, const PictureJob& job,
                          std::size_t shown, Progress& progress);

}  // namespace cbvh::testbench
