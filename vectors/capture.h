// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "golden/build/float_tree.h"
#include "vectors/vector_set.h"

namespace cbvh::vectors {

struct CaptureOptions {
  std::uint64_t cases = 1000;  ///< at most; taken evenly from what there is
  int treelet = 1;             ///< D of the compression that is watched; units with treelets use their own
  golden::Code code = golden::Code::modulo;
  golden::ScaleRule scale_rule = golden::ScaleRule::equation2;
  std::optional<int> min_scale;      ///< the scene's exactness limit when not given
  std::uint32_t episode_pairs = 64;  ///< an episode is a largest subtree of at most so many pairs
};

/// What the unit meets while the golden compresses the tree, with the golden's responses, as cases 0, 1, ... of class
/// kCaptured and seed 0: every axis, estimate or pair of the compression; every stream, stack or memory of a subtree.
/// Throws InputError for bad parameters and for a unit that meets nothing there.
std::unique_ptr<VectorSet> capture_set(std::string_view unit, const Parameters& parameters,
                                       const golden::FloatTree& tree, const CaptureOptions& options);

/// The same, of the linear BVH of a scene: a file or "proc:NAME".
std::unique_ptr<VectorSet> capture_set(std::string_view unit, const Parameters& parameters, const std::string& scene,
                                       const CaptureOptions& options);

}  // namespace cbvh::vectors
