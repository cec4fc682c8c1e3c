// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "golden/quantize/grid.h"
#include "rtl_model/datapath/refit_payloads.h"

namespace cbvh::vectors {

/// An entry of the primitive-ID array and the primitive it names.
struct WalkPrimitive {
  golden::Box box;
  bool last_of_leaf;
  bool in_range = true;
  bool finite = true;
};

struct WalkAnswer {
  std::vector<rtl::StreamJob> jobs;
  rtl::WalkReport report;
};

/// The pairs of a tree in emission order with the boxes of what is below them now. A tree that is none around these
/// primitives ends with its first fault, and a job that is refused.
WalkAnswer walk_tree(std::span<const rtl::TopologyPair> pairs, std::span<const WalkPrimitive> primitives,
                     const rtl::SceneRegisters& registers);

}  // namespace cbvh::vectors
