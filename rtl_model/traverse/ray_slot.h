// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "rtl_model/datapath/ray_job_payloads.h"

namespace cbvh::rtl {

/// Nodes that wait while a ray is below their siblings: a level of the tree leaves at most one.
constexpr std::size_t kRayStackDepth = 32;

/// A node that a ray has reached and will visit: an inner one's pair, or a leaf's entries.
template <int N>
struct WaitingNode {
  UInt<1> leaf;
  Pointer pointer;
  Float32 entry;
  ReachedNode<N> node;
};

/// All that the traversal unit keeps of one ray: registers, a memory of kRayStackDepth nodes, and the last line that
/// was read for it, since a pair's children often lie in the pair's own line.
template <int N>
struct RaySlotState {
  RayJob job;
  std::array<RayAxis, 3> axes;
  Float32 t_max;
  WaitingNode<N> current;
  std::array<WaitingNode<N>, kRayStackDepth> stack;
  std::size_t depth = 0;
  LineWords line;
  std::uint64_t line_number = 0;
  bool has_line = false;
  LineWords id_line;
  RayReport report;
};

}  // namespace cbvh::rtl
