// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "golden/build/builder.h"
#include "golden/build/two_level/top_level.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::testbench {

/// Bits 6, e_min the exactness limit.
golden::GridRules rules_of(const golden::FloatTree& tree);

/// A scene with the trees of its objects, float and compressed.
struct Forest {
  using Compress = std::function<golden::CompressedTree(const golden::FloatTree&)>;

  /// Compressed top-down, with modulo codes.
  Forest(golden::TwoLevelScene from, const golden::Builder& builder);
  Forest(golden::TwoLevelScene from, const golden::Builder& builder, const Compress& compress);
  Forest(const Forest&) = delete;
  Forest& operator=(const Forest&) = delete;

  golden::TwoLevelScene scene;
  std::vector<golden::FloatTree> floats;
  std::vector<golden::CompressedTree> compressed;
  golden::InstancedTrees float_trees{};
  golden::InstancedTrees compressed_trees{};
  golden::Box world{};  ///< around all instances
  std::uint64_t pairs = 0;
  double build_seconds = 0;  ///< of the float trees
};

/// Builds a top level so often, at least once; returns the seconds of the fastest time.
double fastest_build(const golden::TopLevelBuilder& builder, const golden::InstancedTrees& trees, unsigned repeats,
                     golden::TopLevel& top);

/// The top level with the boxes of its compressed tree.
golden::TopLevel decoded(const golden::TopLevel& top, const golden::CompressedTree& compressed);

}  // namespace cbvh::testbench
