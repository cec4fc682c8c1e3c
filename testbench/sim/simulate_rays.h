// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/scene/mesh.h"
#include "golden/trace/ray.h"
#include "testbench/sim/simulate.h"

namespace cbvh::testbench {

/// Which rays of an image go through the unit.
enum class SimulatedRays : std::uint8_t {
  primary,  ///< through the middle of each pixel
  diffuse   ///< from where those hit, in a random diffuse direction
};

/// Rays of the camera that sees all of the scene, row by row; diffuse ones start where a primary ray hits.
std::vector<golden::Ray> image_rays(const golden::Mesh& mesh, const golden::FloatTree& tree, SimulatedRays kind,
                                    unsigned width, unsigned height);

/// What the rays of one simulation cost. All are sums.
struct RaysResult {
  std::string scene;
  std::uint64_t rays = 0;
  std::uint64_t tree_pairs = 0;
  std::uint64_t hits = 0;
  std::uint64_t wrong = 0;  ///< rays whose nearest hit is not the golden's on the float tree
  std::string first_wrong;  ///< of them, if there is one
  std::uint64_t pairs = 0;  ///< visited
  std::uint64_t leaves = 0;
  std::uint64_t candidates = 0;  ///< triangles that came out
  std::uint64_t pair_lines = 0;  ///< 64-byte reads at the memory's ports
  std::uint64_t id_lines = 0;
  std::uint64_t exact_pairs = 0;  ///< that a traversal of the same tree with exact boxes visits, the golden's
  std::uint64_t float_pairs = 0;  ///< that a traversal of the float tree visits: a line each
  std::uint64_t float_triangles = 0;
  std::uint64_t cycles = 0;
  double bound_cycles = 0;
  double clock_mhz = 0;
  double seconds = 0;  ///< of the host
  std::vector<MemoryStatistic> memory;
  std::vector<rtl::ModuleUse> utilisation;

  double per_ray(std::uint64_t sum) const { return static_cast<double>(sum) / static_cast<double>(rays); }
  bool pass() const { return rays > 0 && wrong == 0; }
};
std::string to_text(const RaysResult& result);
Json to_json(const RaysResult& result);

/// Sends rays through the traversal unit over the compressed tree of `floats` in the simulated memory, with `slots` of
/// them at once; triangles are intersected by the golden, and the nearest hits compared with its own. Throws InputError
/// for what cannot be simulated, and Deadlock.
RaysResult simulate_rays(const golden::Mesh& mesh, const golden::FloatTree& floats,
                         const std::vector<golden::Ray>& rays, unsigned slots, const SimRequest& request);

}  // namespace cbvh::testbench
