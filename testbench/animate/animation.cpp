// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/animate/animation.h"

#include <fmt/format.h>

#include <chrono>

#include "golden/input_error.h"
#include "golden/tree/sah.h"
#include "testbench/animate/hit_picture.h"
#include "testbench/option_values.h"

namespace cbvh::testbench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// The builder with so many threads, if it has a choice.
golden::Builder builder_on(const std::string& text, unsigned threads) {
  golden::Builder builder("--builder", text);
  const bool takes_threads = golden::find_named(builder.kind().options, "threads") != nullptr;
  return takes_threads ? golden::Builder("--builder", fmt::format("{},threads={}", text, threads)) : builder;
}

HitPicture picture_of(const golden::FloatTree& tree, const golden::Mesh& mesh, const golden::Box& box,
                      const AnimationJob& job, unsigned threads) {
  return trace_picture(tree, mesh, golden::Camera::around(box), job.width, job.height, threads);
}

}  // namespace

void check_animation_job(const AnimationJob& job) {
  const auto range = [](const char* option, unsigned found, unsigned low, unsigned high) {
    if (found < low || found > high)
      throw golden::InputError(option, fmt::format("found {}, want {}..{}", found, low, high));
  };
  range("--threads", job.threads, 1, 256);
  range("--build-threads", job.build_threads, 1, 255);
  range("--width", job.width, 1, 16384);
  range("--height", job.height, 1, 16384);
  const bool grows = job.rebuild_above >= 1;  // false for NaN
  if (!grows) throw golden::InputError("--rebuild-above", fmt::format("found {}, want 1 or more", job.rebuild_above));
  builder_on(job.builder, job.threads);
}

FreshFrames::FreshFrames(std::vector<std::shared_ptr<const golden::Mesh>> meshes, const AnimationJob& job,
                         Progress& progress)
    : meshes_(std::move(meshes)), box_{meshes_.front()->positions.front(), meshes_.front()->positions.front()} {
  const golden::Builder builder = builder_on(job.builder, job.threads);
  for (const auto& mesh : meshes_) {
    for (const glm::vec3& p : mesh->positions) box_ = golden::unite(box_, {p, p});
  }
  for (const auto& mesh : meshes_) {
    const golden::FloatTree tree = builder.build(*mesh);
    sah_.push_back(golden::sah(tree));
    digests_.push_back(testbench::digest(picture_of(tree, *mesh, box_, job, job.threads)));
    progress.step();
  }
}

std::vector<FrameResult> animate(const FreshFrames& fresh, golden::UpdatePolicy policy, const AnimationJob& job,
                                 Progress& progress) {
  const bool beside = policy == golden::UpdatePolicy::async;
  const unsigned frame_threads =
      !beside ? job.threads : std::max(job.threads, job.build_threads + 1) - job.build_threads;
  golden::AnimatedTree tree(builder_on(job.builder, beside ? job.build_threads : job.threads),
                            {policy, frame_threads, job.rebuild_above});
  std::vector<FrameResult> results;
  for (std::size_t frame = 0; frame < fresh.frames(); ++frame) {
    const Clock::time_point start = Clock::now();
    const golden::FloatTree& current = tree.advance(fresh.mesh(frame));
    const Clock::time_point updated = Clock::now();
    const HitPicture picture = picture_of(current, *fresh.mesh(frame), fresh.box(), job, frame_threads);
    const Clock::time_point traced = Clock::now();
    results.push_back({seconds(updated - start), seconds(traced - updated), golden::sah(current), fresh.sah(frame),
                       picture.counts.box_tests, tree.age(), digest(picture) == fresh.digest(frame)});
    progress.step();
  }
  return results;
}

}  // namespace cbvh::testbench
