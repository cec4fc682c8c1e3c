// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "golden/update/animated_tree.h"
#include "testbench/progress.h"
#include "testbench/report/json.h"

namespace cbvh::testbench {

struct AnimationJob {
  std::string builder = "binned";
  unsigned threads = 2;        ///< N: of building, refitting and tracing where they do not run beside each other
  unsigned build_threads = 1;  ///< K of `async`: of building; N - K update and trace meanwhile
  double rebuild_above = 1.4;  ///< UpdateOptions
  unsigned width = 256;
  unsigned height = 256;
};

/// One frame under one policy.
struct FrameResult {
  double update_seconds;  ///< until the frame's tree is there
  double trace_seconds;   ///< the picture
  double sah;
  double fresh_sah;         ///< of a tree built of this frame
  std::uint64_t box_tests;  ///< of the picture
  unsigned age;             ///< AnimatedTree::age
  bool same_picture;        ///< every pixel's nearest triangle and distance are those of a tree built of this frame
  double seconds() const { return update_seconds + trace_seconds; }
};

/// All frames, at least one of them: a primary ray's hit for each pixel of each frame, and SAH, of trees built anew:
/// what every policy is compared with.
class FreshFrames {
 public:
  FreshFrames(std::vector<std::shared_ptr<const golden::Mesh>> meshes, const AnimationJob& job, Progress& progress);

  std::size_t frames() const { return meshes_.size(); }
  const std::shared_ptr<const golden::Mesh>& mesh(std::size_t frame) const { return meshes_[frame]; }
  double sah(std::size_t frame) const { return sah_[frame]; }
  std::uint64_t digest(std::size_t frame) const { return digests_[frame]; }
  const golden::Box& box() const { return box_; }

 private:
  std::vector<std::shared_ptr<const golden::Mesh>> meshes_;
  golden::Box box_;  ///< of all frames' vertices
  std::vector<double> sah_;
  std::vector<std::uint64_t> digests_;
};

/// Runs all frames under one policy.
std::vector<FrameResult> animate(const FreshFrames& fresh, golden::UpdatePolicy policy, const AnimationJob& job,
                                 Progress& progress);

/// Throws InputError for threads, sizes or factors out of their range, and for a builder that is none.
void check_animation_job(const AnimationJob& job);

}  // namespace cbvh::testbench
