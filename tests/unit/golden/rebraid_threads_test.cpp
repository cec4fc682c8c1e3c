// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Runs under the thread sanitizer too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "golden/scene/two_level/two_level_scenes.h"
#include "tests/unit/golden/two_level_helpers.h"

namespace cbvh::golden {
namespace {

TEST(RebraidThreads, the_same_top_level_for_every_number_of_threads_run_after_run) {
  int checks = 0;
  for (const char* spec : {"bounce,count=600,size=0.5,time=2:proc:soup,triangles=200",
                           "deal,objects=40,chunk=3:proc:terrain,triangles=3000"}) {
    const BuiltScene scene(load_two_level_scene(spec));
    for (const char* builder : {"plain", "rebraid,space=8", "rebraid,width=4,open=leaves,order=cost,triangles=2"}) {
      const TopLevel wanted = scene.build(builder);
      for (int run = 0; run < 10; ++run) {
        for (const int threads : {1, 2, 4}) {
          expect_same(scene.build(fmt::format("{},threads={}", builder, threads)), wanted);
          ++checks;
        }
      }
    }
  }
  EXPECT_EQ(checks, 2 * 3 * 10 * 3);
}

}  // namespace
}  // namespace cbvh::golden
