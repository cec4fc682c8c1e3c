// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/frames.h"

#include <fmt/format.h>

#include <bit>

#include "golden/build/two_level/two_level_sah.h"
#include "golden/input_error.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/threads/parallel_for.h"
#include "golden/trace/camera.h"
#include "golden/trace/two_level/two_level_tracer.h"
#include "golden/update/top_down.h"
#include "testbench/eval/two_level/forest.h"
#include "testbench/fnv.h"
#include "testbench/progress.h"

namespace cbvh::testbench {

namespace {

/// Traces a primary ray for each pixel, and adds what that costs.
void trace_picture(const golden::TopLevel& top, const golden::InstancedTrees& trees, const golden::InstanceRays& rays,
                   const golden::Box& world, const PictureSize& size, FrameMeasure& result) {
  const golden::Camera camera = golden::Camera::around(world);
  std::vector<golden::InstanceHit> hits(std::size_t{size.width} * size.height);
  std::vector<golden::TwoLevelCounts> rows(size.height);
  golden::parallel_for(size.height, size.threads, [&](std::size_t row) {
    golden::TwoLevelTracer tracer(top, trees, rays);
    for (unsigned x = 0; x < size.width; ++x) {
      const golden::Ray ray = camera.ray(x, static_cast<unsigned>(row), size.width, size.height);
      hits[row * size.width + x] = tracer.trace(ray, golden::Stop::closest);
    }
    rows[row] = tracer.counts();
  });
  golden::TwoLevelCounts counts;
  for (const golden::TwoLevelCounts& row : rows) counts.add(row);
  result.rays = hits.size();
  result.box_tests = counts.top.box_tests + counts.objects.box_tests;
  result.triangle_tests = counts.objects.triangle_tests;
  result.transforms = counts.transforms;
  Fnv hash;
  for (const golden::InstanceHit& hit : hits) {
    if (hit != golden::InstanceHit()) ++result.hits;
    hash.add(hit.instance);
    hash.add(hit.primitive);
    hash.add(std::bit_cast<std::uint64_t>(hit.t));
  }
  result.picture = hash.value();
}

FrameMeasure measure(const Forest& forest, bool compressed, const golden::TopLevelBuilder& builder, unsigned repeats,
                     const golden::InstanceRays& rays, const PictureSize& size) {
  const golden::InstancedTrees& trees = compressed ? forest.compressed_trees : forest.float_trees;
  FrameMeasure result;
  golden::TopLevel top;
  result.build_seconds = fastest_build(builder, trees, repeats, top);
  if (compressed) top = decoded(top, golden::compress_top_down(top.tree, rules_of(top.tree), golden::Code::modulo));
  result.references = top.references.size();
  result.sah = golden::two_level_sah(top, trees, forest.world);
  trace_picture(top, trees, rays, forest.world, size, result);
  return result;
}

void check(const PictureSize& size) {
  const auto range = [](const char* option, unsigned found, unsigned high) {
    if (found < 1 || found > high) throw golden::InputError(option, fmt::format("found {}, want 1..{}", found, high));
  };
  range("--width", size.width, 16384);
  range("--height", size.height, 16384);
  range("--threads", size.threads, 256);
}

}  // namespace

std::vector<FramesMeasure> measure_frames(const TwoLevelJob& job, unsigned frames, const PictureSize& size) {
  check(size);
  const golden::Builder objects("--objects", job.objects);
  std::vector<golden::TopLevelBuilder> tops;
  for (const std::string& text : job.tops) tops.emplace_back("--top", text);
  for (const std::string& scene : job.scenes) {
    const std::string start = name_of_frame({scene, 0, frames}, 0);
    golden::load_two_level_scene(start);
    if (frames > 1 && name_of_frame({scene, 0, frames}, 1) == start)
      throw golden::InputError("--frames", fmt::format("nothing moves in {}, want {{time}} in it", scene));
  }
  std::vector<FramesMeasure> results;
  Progress progress("eval two-level", std::uint64_t{frames} * job.scenes.size());
  for (const std::string& scene : job.scenes) {
    const std::size_t first = results.size();
    for (const golden::TopLevelBuilder& top : tops) {
      for (const char* trees : {"float", "compressed"}) results.push_back({scene, top.text(), trees, {}});
    }
    for (unsigned frame = 0; frame < frames; ++frame) {
      const Forest forest(golden::load_two_level_scene(name_of_frame({scene, 0, frames}, frame)), objects);
      const golden::InstanceRays rays(forest.scene);
      for (std::size_t i = first; i < results.size(); ++i) {
        const std::size_t which = i - first;
        FrameMeasure measured = measure(forest, which % 2 == 1, tops[which / 2], job.repeats, rays, size);
        measured.frame = frame;
        measured.same_picture = i == first || measured.picture == results[first].frames[frame].picture;
        results[i].frames.push_back(measured);
      }
      progress.step();
    }
  }
  return results;
}

}  // namespace cbvh::testbench
