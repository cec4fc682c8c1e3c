// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/eval/table.h"
#include "testbench/trace/compression.h"
#include "testbench/trace/picture.h"

namespace cbvh::testbench {

/// What one picture's box tests were.
struct IntervalsResult {
  std::string scene;
  int bits = 0;
  std::uint64_t rays = 0;
  std::uint64_t box_tests = 0;         ///< of the unit: each checked, on every axis
  std::uint64_t golden_box_tests = 0;  ///< of the same rays, with exact intervals but for 2^-50
  std::vector<std::string> failures;   ///< the violation that ended the run
};

/// Sends the rays of a picture through the mesh's compressed tree by the unit's datapaths, and checks every interval.
IntervalsResult check_intervals(const golden::Mesh& mesh, const golden::CompressedTree& tree, const PictureJob& job);

Table intervals_table(const IntervalsResult& result);

}  // namespace cbvh::testbench
