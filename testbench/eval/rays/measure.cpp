// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/rays/measure.h"

#include <fmt/format.h>

#include "golden/build/builder.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/trace/compressed_view.h"
#include "golden/update/top_down.h"
#include "testbench/trace/picture_report.h"

namespace cbvh::testbench {

namespace {

/// One scene's trees: the float tree, then those of kTracedBits.
class Trees {
 public:
  Trees(const golden::Mesh& mesh, const golden::Builder& builder, golden::Code code)
      : mesh_(mesh), floats_(builder.build(mesh)) {
    for (const int bits : kTracedBits) {
      const golden::GridRules rules{.bits = bits, .min_scale = golden::exactness_limit(floats_.largest_magnitude)};
      compressed_.push_back(golden::compress_top_down(floats_, rules, code));
    }
  }

  const golden::Box& box() const { return floats_.scene; }

  std::vector<PictureTree> all() const {
    std::vector<PictureTree> trees = {{"float", [this](const Shot& shot) {
                                         return pixel_source(golden::TracedMesh(golden::FloatTreeView(floats_), mesh_),
                                                             shot);
                                       }}};
    for (const golden::CompressedTree& tree : compressed_) {
      trees.push_back({fmt::format("N = {}", tree.rules.bits), [this, &tree](const Shot& shot) {
                         return pixel_source(golden::TracedMesh(golden::CompressedTreeView(tree), mesh_), shot);
                       }});
    }
    return trees;
  }

 private:
  const golden::Mesh& mesh_;
  golden::FloatTree floats_;
  std::vector<golden::CompressedTree> compressed_;
};

RaysMeasure measure(const std::string& scene, golden::RayKind kind, const TracedPicture& picture) {
  const auto counts = [&](const TreeCost& tree) {
    return kind == golden::RayKind::primary ? tree.primary : tree.secondary;
  };
  RaysMeasure result{scene, std::string(kRayKinds[static_cast<std::size_t>(kind)]), counts(picture.trees[0]), {}};
  for (std::size_t i = 0; i < kTracedBits.size(); ++i) result.compressed[i] = counts(picture.trees[i + 1]);
  return result;
}

}  // namespace

RaysMeasurement measure_rays(const RaysJob& job) {
  check_picture_job(job.picture);
  const golden::Builder builder("--builder", job.builder);
  std::vector<golden::Mesh> meshes;
  for (const std::string& scene : job.scenes) meshes.push_back(golden::load_scene(scene));
  RaysMeasurement result;
  Progress progress("eval rays", meshes.size() * kRayKinds.size() * (1 + kTracedBits.size()) * job.picture.height);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Trees trees(meshes[i], builder, job.code);
    for (const golden::RayKind kind : {golden::RayKind::primary, golden::RayKind::occlusion, golden::RayKind::path}) {
      PictureJob picture = job.picture;
      picture.rays = kind;
      const TracedPicture traced = trace_trees(trees.all(), trees.box(), picture, 0, progress);
      result.measures.push_back(measure(meshes[i].name, kind, traced));
      result.checks += traced.pixels.size();
      if (traced.different_pixels > 0)
        result.failures.push_back(
            fmt::format("{}: {} pixels differ, {}", job.scenes[i], traced.different_pixels, traced.first_difference));
    }
  }
  return result;
}

}  // namespace cbvh::testbench
