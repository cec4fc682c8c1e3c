// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>

#include "golden/input_error.h"
#include "golden/threads/parallel_for.h"

namespace cbvh::testbench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMostPixels = 1U << 25U;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

bool same(const TracedPixel& a, const TracedPixel& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (bits(a.normal[axis]) != bits(b.normal[axis])) return false;
  }
  return a.hit.instance == b.hit.instance && a.hit.primitive == b.hit.primitive && bits(a.hit.t) == bits(b.hit.t) &&
         bits(a.light) == bits(b.light) && a.secondary.rays == b.secondary.rays;
}

std::string in_words(const TracedPixel& pixel) {
  if (pixel.hit == golden::InstanceHit()) return "nothing";
  return fmt::format("triangle {} of instance {} at {:a}, light {:a}", pixel.hit.primitive, pixel.hit.instance,
                     pixel.hit.t, pixel.light);
}

/// A pixel of a row, as one tree sees it, added up.
void add(const TracedPixel& pixel, TreeCost& cost) {
  cost.primary.add(pixel.primary);
  cost.secondary.add(pixel.secondary);
}

std::uint8_t to_byte(double from_0_to_1) { return static_cast<std::uint8_t>(std::lround(from_0_to_1 * 255)); }

PixelFigures figures(const TracedPixel& pixel, bool different) {
  const auto channel = [&](int axis) { return to_byte(pixel.normal[axis] * 0.5 + 0.5); };
  golden::TraceCounts tests = pixel.primary.tests;
  tests.add(pixel.secondary.tests);
  return {static_cast<std::uint32_t>(tests.box_tests),
          static_cast<std::uint32_t>(tests.triangle_tests),
          to_byte(std::sqrt(pixel.light)),
          {channel(0), channel(1), channel(2)},
          pixel.hit != golden::InstanceHit(),
          different};
}

/// Three numbers, and nothing behind them.
glm::dvec3 parse_point(const std::string& text) {
  glm::dvec3 point(0);
  std::size_t start = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis == 2 ? text.size() : text.find(',', start);
    std::size_t used = 0;
    try {
      point[axis] = std::stod(text.substr(start, end - start), &used);
    } catch (const std::exception&) {
      used = std::string::npos;
    }
    if (end == std::string::npos || used != end - start)
      throw golden::InputError("--camera", fmt::format("found '{}', want three numbers, X,Y,Z", text));
    start = end + 1;
  }
  return point;
}

golden::Camera parse_camera(const std::string& text) {
  const std::size_t first = text.find(':');
  if (first == std::string::npos) {
    throw golden::InputError("--camera",
                             fmt::format("found '{}', want around, inside or EX,EY,EZ:TX,TY,TZ[:HALF_HEIGHT]", text));
  }
  const std::size_t second = text.find(':', first + 1);
  double half_height = 0.5;
  if (second != std::string::npos) {
    const std::string number = text.substr(second + 1);
    std::size_t used = 0;
    try {
      half_height = std::stod(number, &used);
    } catch (const std::exception&) {
      used = std::string::npos;
    }
    if (used != number.size())
      throw golden::InputError("--camera", fmt::format("found half height '{}', want a number", number));
  }
  const glm::dvec3 eye = parse_point(text.substr(0, first));
  const glm::dvec3 target = parse_point(text.substr(first + 1, second - std::min(second, first + 1)));
  const glm::dvec3 along = target - eye;
  const bool upright = std::abs(along.x) + std::abs(along.z) > 1e-6 * std::abs(along.y);
  return {"--camera", eye, target, upright ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), half_height};
}

}  // namespace

void check_picture_job(const PictureJob& job) {
  const auto range = [](const char* option, unsigned found, unsigned low, unsigned high) {
    if (found < low || found > high)
      throw golden::InputError(option, fmt::format("found {}, want {}..{}", found, low, high));
  };
  range("--width", job.width, 1, 16384);
  range("--height", job.height, 1, 16384);
  range("--samples", job.samples, 1, 65536);
  range("--threads", job.threads, 0, 256);
  const std::uint64_t pixels = std::uint64_t{job.width} * job.height;
  if (pixels > kMostPixels) {
    throw golden::InputError("--width",
                             fmt::format("found {} x {}, want at most {} pixels", job.width, job.height, kMostPixels));
  }
}

golden::Camera camera_of(const PictureJob& job, const golden::Box& box) {
  const golden::Camera camera = job.camera == "around"   ? golden::Camera::around(box)
                                : job.camera == "inside" ? golden::Camera::inside(box)
                                                         : parse_camera(job.camera);
  for (const unsigned x : {0U, job.width - 1}) {
    for (const unsigned y : {0U, job.height - 1}) {
      golden::check_ray(camera.ray(x, y, job.width, job.height),
                        fmt::format("--camera {}: ray of pixel {} {}", job.camera, x, y));
    }
  }
  return camera;
}

TracedPicture trace_trees(const std::vector<PictureTree>& trees, const golden::Box& box, const PictureJob& job,
                          std::size_t shown, Progress& progress) {
  check_picture_job(job);
  const Shot shot{camera_of(job, box), job.rays, job.samples};
  TracedPicture picture{job.width, job.height, {}, {}, 0, 0, ""};
  picture.pixels.resize(std::size_t{job.width} * job.height);
  for (const PictureTree& tree : trees) picture.trees.push_back({tree.name, {}, {}, 0, 0});
  unsigned row_of_difference = job.height;
  std::mutex mutex;  // of the picture but its pixels
  golden::parallel_for(job.height, job.threads, [&](std::size_t number) {
    const auto row = static_cast<unsigned>(number);
    std::vector<TreeCost> costs(trees.size());
    std::vector<TracedPixel> first(job.width);
    std::vector<bool> different(job.width, false);
    std::string difference;
    for (std::size_t i = 0; i < trees.size(); ++i) {
      const std::unique_ptr<PixelSource> source = trees[i].pixels(shot);
      std::vector<TracedPixel> pixels(job.width);
      const Clock::time_point start = Clock::now();
      for (unsigned x = 0; x < job.width; ++x) pixels[x] = source->trace(x, row, job.width, job.height);
      costs[i].seconds = std::chrono::duration<double>(Clock::now() - start).count();
      if (i == 0) first = pixels;
      for (unsigned x = 0; x < job.width; ++x) {
        add(pixels[x], costs[i]);
        const bool differs = !same(pixels[x], first[x]);
        costs[i].different_pixels += differs ? 1 : 0;
        different[x] = different[x] || differs;
        if (differs && difference.empty()) {
          difference = fmt::format("pixel {} {}: {} tree: {}; {} tree: {}", x, row, trees[i].name, in_words(pixels[x]),
                                   trees[0].name, in_words(first[x]));
        }
        if (i == shown) picture.pixels[number * job.width + x] = figures(pixels[x], false);
      }
      progress.step();
    }
    const std::lock_guard lock(mutex);
    for (unsigned x = 0; x < job.width; ++x) {
      PixelFigures& pixel = picture.pixels[number * job.width + x];
      pixel.different = different[x];
      picture.different_pixels += different[x] ? 1 : 0;
      picture.hits += pixel.hit ? 1 : 0;
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
      picture.trees[i].primary.add(costs[i].primary);
      picture.trees[i].secondary.add(costs[i].secondary);
      picture.trees[i].seconds += costs[i].seconds;
      picture.trees[i].different_pixels += costs[i].different_pixels;
    }
    if (!difference.empty() && row < row_of_difference) {
      row_of_difference = row;
      picture.first_difference = difference;
    }
  });
  return picture;
}

}  // namespace cbvh::testbench
