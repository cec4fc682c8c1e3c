// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/two_level_sah.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "golden/build/two_level/reference_tree.h"

namespace cbvh::golden {
namespace {

using Kind = ObjectNode::Kind;

/// Areas of a box's faces across x, y and z: together half its surface.
glm::dvec3 faces(const Box& box) {
  const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  return {extent.y * extent.z, extent.z * extent.x, extent.x * extent.y};
}

/// By how much a transform enlarges those faces.
glm::dvec3 enlargement(const glm::mat4& to_world) {
  if (is_identity(to_world)) return glm::dvec3(1.0);
  const glm::dvec3 x(to_world[0]);
  const glm::dvec3 y(to_world[1]);
  const glm::dvec3 z(to_world[2]);
  return {glm::length(glm::cross(y, z)), glm::length(glm::cross(z, x)), glm::length(glm::cross(x, y))};
}

double cost_of(const ObjectNode& node, const ObjectTree& tree, const SahCosts& costs) {
  if (node.kind == Kind::pair) return costs.traversal;
  if (node.kind == Kind::primitive) return costs.intersection;
  return costs.intersection * static_cast<double>(leaf_size(tree.primitive_ids(), node.index));
}

/// Cost times faces, and cost alone.
struct Sum {
  glm::dvec3 faces{0.0};
  double count = 0;
  Sum& operator+=(const Sum& other) {
    faces += other.faces;
    count += other.count;
    return *this;
  }
};

/// Of each pair of an object's tree: the sum over all nodes below it.
std::vector<Sum> sums_below(const ObjectTree& tree, const SahCosts& costs) {
  std::vector<Sum> below(tree.pairs());
  std::vector<ObjectNode> node(tree.pairs());
  if (below.empty()) return below;
  node.back() = tree.root().node;
  for (std::size_t pair = below.size(); pair-- > 0;) {  // parents before children
    for (const BoxedNode& child : tree.children(node[pair])) {
      const double cost = cost_of(child.node, tree, costs);
      below[pair] += {faces(child.box) * cost, cost};
      if (child.node.kind == Kind::pair) node[child.node.index] = child.node;
    }
  }
  for (std::size_t pair = 0; pair < below.size(); ++pair) {
    for (const BoxedNode& child : tree.children(node[pair])) {
      if (child.node.kind == Kind::pair) below[pair] += below[child.node.index];
    }
  }
  return below;
}

}  // namespace

Box world_of(const InstancedTrees& trees) {
  WideBox world;
  for (const BuildReference& reference : whole_instances(trees)) world.enclose(reference.bounds);
  return narrowed(world);
}

double two_level_sah(const TopLevel& top, const InstancedTrees& trees, const Box& world, const SahCosts& costs) {
  const double world_area = half_area(world);
  const auto relative = [world_area](double area) { return world_area > 0 ? area / world_area : 1.0; };
  std::vector<std::vector<Sum>> below;
  for (const auto& tree : trees.trees) below.push_back(sums_below(*tree, costs));

  const auto reference_cost = [&](std::uint32_t entry, const Box& box) {
    const SubtreeReference& to = top.references[top.tree.primitive_ids[entry] & ~kLastOfLeaf];
    const Instance& instance = trees.scene->instances[to.instance];
    double cost = cost_of(to.node, *trees.trees[instance.object], costs) * relative(half_area(box));
    if (to.node.kind == Kind::pair) {
      const Sum& sum = below[instance.object][to.node.index];
      const double area = glm::dot(sum.faces, enlargement(instance.to_world));
      cost += world_area > 0 ? area / world_area : sum.count;
    }
    return cost;
  };
  if (top.tree.pairs.empty()) return reference_cost(0, top.tree.scene);
  double total = costs.traversal * relative(half_area(top.tree.scene));
  for (const FloatPair& pair : top.tree.pairs) {
    for (int c = 0; c < 2; ++c) {
      total += pair.leaf[c] ? reference_cost(pair.pointer[c], pair.child[c])
                            : costs.traversal * relative(half_area(pair.child[c]));
    }
  }
  return total;
}

}  // namespace cbvh::golden
