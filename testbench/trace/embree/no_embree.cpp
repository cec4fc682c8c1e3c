// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/embree/embree_scene.h"
#include "testbench/unavailable.h"

namespace cbvh::testbench {

struct EmbreeScene::Handles {};

EmbreeScene::EmbreeScene(const golden::Mesh&, bool) {
  throw Unavailable("trace: this build has no Embree 3 (Debian package libembree-dev, then CBVH_WITH_EMBREE=ON)");
}

EmbreeScene::~EmbreeScene() = default;

EmbreeHit EmbreeScene::trace(const golden::Ray&) const { return {}; }

}  // namespace cbvh::testbench
