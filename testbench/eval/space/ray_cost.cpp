// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/ray_cost.h"

#include <algorithm>

#include "golden/threads/parallel_for.h"
#include "golden/trace/random_rays.h"

namespace cbvh::testbench {

RayCosts trace_random_rays(const golden::FloatTree& tree, const golden::Mesh& mesh, RandomRays kind, std::uint64_t rays,
                           unsigned threads) {
  constexpr std::uint64_t kBatch = 1024;
  const std::uint64_t batches = (rays + kBatch - 1) / kBatch;
  RayCosts result;
  result.hits.resize(rays);
  std::vector<golden::TraceCounts> counts(batches);
  golden::parallel_for(batches, threads, [&](std::size_t batch) {
    golden::Tracer tracer(golden::FloatTreeView(tree), mesh);
    for (std::uint64_t ray = batch * kBatch; ray < std::min(rays, (batch + 1) * kBatch); ++ray) {
      result.hits[ray] = kind == RandomRays::terminating
                             ? tracer.trace(golden::ray_from_within(tree.scene, ray), golden::Stop::closest)
                             : tracer.trace(golden::ray_across(tree.scene, ray), golden::Stop::never);
    }
    counts[batch] = tracer.counts();
  });
  for (const golden::TraceCounts& of_batch : counts) result.counts.add(of_batch);
  return result;
}

}  // namespace cbvh::testbench
