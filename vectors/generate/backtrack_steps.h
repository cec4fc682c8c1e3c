// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "vectors/faces/pair.h"
#include "vectors/random.h"

namespace cbvh::vectors {

/// A step of an episode in plain numbers: memory holds `pair` at `index`, or `index` is to be repaired.
struct PlainBacktrackStep {
  bool repair;
  std::uint32_t index;
  golden::CompressedPair pair;
  golden::Context<Index> before;
  golden::Context<Index> after;
  rtl::SceneRegisters registers;
};

inline constexpr std::array<std::string_view, 16> kBacktrackClasses = {
    "leaf-pair", "stops-at-once", "both-children",   "left-spine", "right-spine", "random-shape",
    "scattered", "full-span",     "identical-boxes", "planar",     "lower-only",  "one-axis",
    "no-change", "far-coarser",   "two-jobs",        "from-stream"};
std::vector<PlainBacktrackStep> make_backtrack_steps(std::size_t case_class, Random& random, int bits);

/// A stream as the backtrack unit sees it: final pairs become memory, and those that invalidate a child become jobs.
std::vector<PlainBacktrackStep> backtrack_steps_of(std::span<const rtl::StreamJob> jobs, int levels, int bits);

}  // namespace cbvh::vectors
