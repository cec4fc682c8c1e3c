// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/ray_cost.h"

#include <gtest/gtest.h>

#include "golden/build/builder.h"
#include "golden/scene/load.h"
#include "golden/trace/random_rays.h"

namespace cbvh::testbench {
namespace {

TEST(RayCost, is_that_of_the_rays_one_by_one_however_many_threads_trace_them) {
  const golden::Mesh mesh = golden::load_scene("proc:soup,triangles=200");
  const golden::FloatTree tree = golden::Builder("test", "sweep").build(mesh);
  for (const std::uint64_t rays : {1U, 1024U, 2500U}) {
    for (const RandomRays kind : {RandomRays::terminating, RandomRays::through}) {
      golden::Tracer tracer(golden::FloatTreeView(tree), mesh);
      std::vector<golden::Hit> hits;
      for (std::uint64_t i = 0; i < rays; ++i) {
        hits.push_back(kind == RandomRays::terminating
                           ? tracer.trace(golden::ray_from_within(tree.scene, i), golden::Stop::closest)
                           : tracer.trace(golden::ray_across(tree.scene, i), golden::Stop::never));
      }
      for (const unsigned threads : {1U, 3U}) {
        const RayCosts costs = trace_random_rays(tree, mesh, kind, rays, threads);
        EXPECT_EQ(costs.counts, tracer.counts());
        EXPECT_EQ(costs.hits, hits);
      }
    }
  }
}

}  // namespace
}  // namespace cbvh::testbench
