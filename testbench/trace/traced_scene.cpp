// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/traced_scene.h"

#include "golden/build/builder.h"
#include "golden/build/two_level/two_level_sah.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/trace/compressed_view.h"
#include "golden/trace/two_level/traced_instances.h"
#include "testbench/eval/two_level/forest.h"
#include "testbench/trace/compression.h"

namespace cbvh::testbench {

namespace {

class MeshScene : public TracedScene {
 public:
  explicit MeshScene(const TraceTrees& trees)
      : mesh_(golden::load_scene(trees.scene)), trees_(build_and_compress(mesh_, trees)) {}

  const golden::Box& box() const override { return trees_.floats.scene; }
  std::uint64_t triangles() const override { return mesh_.triangles.size(); }
  bool identical() const override { return trees_.identical; }

  std::unique_ptr<PixelSource> pixels(bool compressed, const Shot& shot) const override {
    if (compressed) return pixel_source(golden::TracedMesh(golden::CompressedTreeView(trees_.compressed), mesh_), shot);
    return pixel_source(golden::TracedMesh(golden::FloatTreeView(trees_.floats), mesh_), shot);
  }

 private:
  golden::Mesh mesh_;
  TreePair trees_;
};

class InstancesScene : public TracedScene {
 public:
  explicit InstancesScene(const TraceTrees& trees)
      : forest_(golden::load_two_level_scene(trees.scene), golden::Builder("--builder", trees.builder),
                [&](const golden::FloatTree& tree) { return compressed_tree(tree, trees); }),
        rays_(forest_.scene) {
    const golden::TopLevelBuilder builder("--top", trees.top);
    floats_ = builder.build(forest_.float_trees);
    compressed_ = builder.build(forest_.compressed_trees);
    compressed_ = decoded(compressed_, compressed_tree(compressed_.tree, trees));
  }

  const golden::Box& box() const override { return forest_.world; }
  std::uint64_t triangles() const override { return golden::instanced_triangles(forest_.scene); }
  bool identical() const override { return identical_; }

  std::unique_ptr<PixelSource> pixels(bool compressed, const Shot& shot) const override {
    const golden::InstancedTrees& trees = compressed ? forest_.compressed_trees : forest_.float_trees;
    return pixel_source(golden::TracedInstances(compressed ? compressed_ : floats_, trees, rays_, forest_.world), shot);
  }

 private:
  golden::CompressedTree compressed_tree(const golden::FloatTree& tree, const TraceTrees& trees) {
    TreePair pair = compress(tree, trees);
    identical_ = identical_ && pair.identical;
    return std::move(pair.compressed);
  }

  bool identical_ = true;
  Forest forest_;
  golden::InstanceRays rays_;
  golden::TopLevel floats_;
  golden::TopLevel compressed_;
};

}  // namespace

bool names_instances(const std::string& scene) {
  const std::size_t colon = scene.find(':');
  if (colon == std::string::npos) return false;
  const std::string_view kind = golden::name_of(std::string_view(scene).substr(0, colon));
  return golden::find_named(golden::two_level_kinds(), kind) != nullptr;
}

std::unique_ptr<TracedScene> load_traced_scene(const TraceTrees& trees) {
  if (!names_instances(trees.scene)) return std::make_unique<MeshScene>(trees);
  if (trees.compression == Compression::refitted)
    throw golden::InputError("--compression", "found refitted, want streaming or top-down for a scene of instances");
  return std::make_unique<InstancesScene>(trees);
}

}  // namespace cbvh::testbench
