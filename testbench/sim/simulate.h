// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "golden/scene/mesh.h"
#include "golden/tree/compressed_tree.h"
#include "testbench/sim/machine.h"
#include "testbench/sim/sim_config.h"
#include "testbench/sim/sim_result.h"

namespace cbvh::testbench {

struct SimRequest {
  SimConfig config;
  MachineOptions machine;
  std::string trace_path;  ///< the memory's accesses as Ramulator reads them; empty: none
};

/// Runs the LBVH pipeline from triangles in the simulated memory to a tree and an ID array there, and compares both
/// with the golden's. Throws InputError for what cannot be simulated, and Deadlock.
SimResult simulate_lbvh(const golden::Mesh& mesh, const SimRequest& request);

/// Runs the refit unit over `tree` in the simulated memory with the mesh's triangles, in place, and compares. Throws
/// InputError when the tree does not belong to the triangles, and Deadlock.
SimResult simulate_refit(const golden::CompressedTree& tree, const golden::Mesh& mesh, const SimRequest& request);

/// The configuration's output in a few words.
std::string describe_output(const SimConfig& config);
/// Throws InputError when the scene has more than max_triangles.
void check_triangles(const std::string& scene, std::uint64_t triangles, const SimConfig& config);
/// The e_min asked for, or the scene's exactness limit. Throws InputError below that: the hardware refuses it.
int checked_min_scale(const SimConfig& config, const golden::FloatTree& floats);

}  // namespace cbvh::testbench
