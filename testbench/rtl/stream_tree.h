// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"
#include "testbench/rtl/stream_run.h"

namespace cbvh::testbench {

/// A tree as the RTL stream compressor left it in memory.
struct StreamedTree {
  golden::CompressedTree tree;
  std::uint64_t repairs = 0;
  std::uint64_t cycles = 0;
};

struct StreamOptions {
  golden::GridRules rules;
  golden::Code code = golden::Code::modulo;
  int treelet = 1;
  Collector collector = Collector::full;
  RunOptions run;
};

/// Streams a whole tree through the RTL. Throws InputError when the hardware refuses it (an e_min below the exactness
/// limit) or hangs.
StreamedTree stream_tree(const golden::FloatTree& tree, const StreamOptions& options);

}  // namespace cbvh::testbench
