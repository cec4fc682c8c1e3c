// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/spatial.h"

#include "golden/build/piece_build.h"
#include "golden/build/space_split.h"

namespace cbvh::golden {
namespace {

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  SpaceRules rules;
  rules.objects = options.integer("objects") == 1;
  rules.exact_costs = options.integer("tight") == 1;
  rules.gain = options.values.at("gain");
  rules.references = options.integer("references");
  return build_by_space(mesh, build_limits(options, mesh.triangles.size(), mesh.name), rules);
}

}  // namespace

BuilderKind spatial_builder() {
  std::vector<Option> options = limit_options();
  options.push_back({"objects", "1: the cheaper of the plane and the centroid sweep", 0, 0, 1});
  options.push_back({"tight", "1: planes weighed by the tight boxes of their sides, section 5.2", 0, 0, 1});
  options.push_back({"gain", "how much cheaper a plane has to be, as a fraction of what it replaces", 0, 0, 1, false});
  options.push_back(references_option());
  return {"spatial", "SS-BVH: planes that split triangles, by SAH (Popov et al., section 5)", options, build};
}

}  // namespace cbvh::golden
