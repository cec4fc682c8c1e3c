// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/kdtree.h"

#include "golden/build/piece_build.h"
#include "golden/build/space_split.h"

namespace cbvh::golden {
namespace {

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  SpaceRules rules;
  rules.tight = false;
  rules.references = options.integer("references");
  return build_by_space(mesh, build_limits(options, mesh.triangles.size(), mesh.name), rules);
}

}  // namespace

BuilderKind kdtree_builder() {
  std::vector<Option> options = limit_options();
  options.push_back(references_option());
  return {"kdtree", "KD-BVH: a SAH k-d tree without its empty leaves, boxes refitted (Popov et al., section 4.5)",
          options, build};
}

}  // namespace cbvh::golden
