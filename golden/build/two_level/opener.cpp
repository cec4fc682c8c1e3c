// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/opener.h"

#include <algorithm>

namespace cbvh::golden {

using Kind = ObjectNode::Kind;

Opener::Opener(const InstancedTrees& trees, std::uint32_t width, bool leaves)
    : trees_(trees), width_(width), leaves_(leaves) {}

void Opener::open(const BuildReference& reference, std::size_t most, std::vector<BuildReference>& children) const {
  children.clear();
  if (reference.to.node.kind == Kind::pair) {
    open_pair(reference, most, children);
  } else {
    open_leaf(reference, most, children);
  }
  const auto count = static_cast<std::uint32_t>(children.size());
  for (BuildReference& child : children) child.primitives = (reference.primitives + count - 1) / count;
}

void Opener::open_pair(const BuildReference& reference, std::size_t most, std::vector<BuildReference>& children) const {
  const std::uint32_t id = reference.to.instance;
  const Instance& instance = trees_.scene->instances[id];
  const ObjectTree& tree = *trees_.trees[instance.object];
  const auto referring = [&](const BoxedNode& node) {
    return BuildReference{widened(bounds_in_world(node.box, instance)), 0, {id, node.node}};
  };
  for (const BoxedNode& child : tree.children(reference.to.node)) children.push_back(referring(child));
  while (children.size() < width_ && children.size() < most) {
    const auto area = [](const BuildReference& child) {
      return child.to.node.kind == Kind::pair ? half_area(child.bounds) : -1;
    };
    const auto largest = std::max_element(children.begin(), children.end(),
                                          [&](const auto& a, const auto& b) { return area(a) < area(b); });
    if (largest->to.node.kind != Kind::pair) break;
    const auto [left, right] = tree.children(largest->to.node);
    *largest = referring(left);
    children.push_back(referring(right));
  }
}

void Opener::open_leaf(const BuildReference& reference, std::size_t most, std::vector<BuildReference>& children) const {
  const std::uint32_t id = reference.to.instance;
  const Instance& instance = trees_.scene->instances[id];
  const std::vector<std::uint32_t>& ids = trees_.trees[instance.object]->primitive_ids();
  const std::uint32_t first = reference.to.node.index;
  const std::uint32_t size = leaf_size(ids, first);
  if (size > most) return;
  for (std::uint32_t i = first; i < first + size; ++i) {
    const std::uint32_t triangle = ids[i] & ~kLastOfLeaf;
    children.push_back({triangle_bounds(instance, triangle), 0, {id, {Kind::primitive, triangle, {}}}});
  }
}

WideBox Opener::triangle_bounds(const Instance& instance, std::uint32_t triangle) const {
  const Mesh& mesh = trees_.scene->objects[instance.object];
  WideBox bounds;
  for (glm::length_t corner = 0; corner < 3; ++corner) {
    const glm::vec3 position = mesh.positions[mesh.triangles[triangle][corner]] + 0.0F;  // -0 + 0 is 0
    bounds.enclose(widened(bounds_in_world({position, position}, instance)));
  }
  return bounds;
}

}  // namespace cbvh::golden
