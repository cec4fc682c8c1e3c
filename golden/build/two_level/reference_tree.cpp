// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/reference_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace cbvh::golden {

Box bounds_in_world(const Box& box, const Instance& instance) {
  if (is_identity(instance.to_world)) return box;
  constexpr float kMax = std::numeric_limits<float>::max();
  const Box world = world_box(box, instance.to_world);
  return {glm::max(world.lower, -kMax), glm::min(world.upper, kMax)};
}

std::vector<BuildReference> whole_instances(const InstancedTrees& trees) {
  unsigned halvings = 0;
  while (instanced_triangles(*trees.scene) >> halvings >= std::uint64_t{1} << 31) ++halvings;
  const auto count = static_cast<std::uint32_t>(trees.scene->instances.size());
  std::vector<BuildReference> references(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Instance& placed = trees.scene->instances[i];
    const ObjectTree& tree = *trees.trees[placed.object];
    const BoxedNode root = tree.root();
    references[i] = {
        widened(bounds_in_world(root.box, placed)), std::max(1U, tree.primitives() >> halvings), {i, root.node}};
  }
  return references;
}

TopLevel emit_references(const NodeTree& tree, std::span<const BuildReference> from, const std::string& place) {
  TopLevel result;
  result.tree = emit(tree, 0, place);
  result.tree.primitives = result.tree.leaves;
  result.references.reserve(result.tree.leaves);
  for (std::uint32_t& id : result.tree.primitive_ids) {
    const std::uint32_t reference = id & ~kLastOfLeaf;
    id = static_cast<std::uint32_t>(result.references.size()) | kLastOfLeaf;
    result.references.push_back(from[reference].to);
  }
  return result;
}

}  // namespace cbvh::golden
