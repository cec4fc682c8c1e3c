// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "golden/build/lbvh.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/update/refit.h"

namespace cbvh::golden {
namespace {

void expect_same_boxes(const FloatTree& found, const FloatTree& wanted) {
  ASSERT_EQ(found.pairs.size(), wanted.pairs.size());
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i)
    ASSERT_EQ(std::memcmp(found.pairs[i].child, wanted.pairs[i].child, sizeof wanted.pairs[i].child), 0)
        << "pair " << i;
  ASSERT_EQ(std::memcmp(&found.scene, &wanted.scene, sizeof wanted.scene), 0);
  ASSERT_EQ(found.largest_magnitude, wanted.largest_magnitude);
}

TEST(Refit, on_many_threads_is_that_on_one_bit_for_bit) {
  for (const char* scene :
       {"proc:terrain,triangles=20000", "proc:soup,triangles=9000", "proc:spheres,triangles=3000,spheres=5"}) {
    Mesh mesh = load_scene(scene);
    const FloatTree before = build_lbvh(mesh);
    for (glm::vec3& p : mesh.positions) p = glm::vec3(p.z * 3, -p.x, p.y + p.x);
    const FloatTree wanted = refit(before, mesh);
    for (const unsigned threads : {2U, 3U, 4U, 16U}) {
      FloatTree found = before;
      refit_in_place(found, mesh, threads);
      expect_same_boxes(found, wanted);
    }
  }
}

TEST(Refit, of_small_trees_uses_threads_too) {
  for (std::uint64_t id = 0; id < 60; ++id) {
    Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 40);
    const FloatTree before = build_lbvh(mesh);
    for (glm::vec3& p : mesh.positions) p = glm::vec3(p.y, p.z, p.x * 0.5F);
    FloatTree found = before;
    refit_in_place(found, mesh, 4);
    expect_same_boxes(found, refit(before, mesh));
  }
}

}  // namespace
}  // namespace cbvh::golden
