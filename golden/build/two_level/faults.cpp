// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/faults.h"

#include <fmt/format.h>

#include "golden/build/two_level/reference_tree.h"

namespace cbvh::golden {
namespace {

using Kind = ObjectNode::Kind;

bool encloses(const Box& outer, const Box& inner) {
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    if (inner.lower[axis] < outer.lower[axis] || inner.upper[axis] > outer.upper[axis]) return false;
  }
  return true;
}

class Check {
 public:
  Check(const TopLevel& of, const InstancedTrees& in, std::size_t at_most) : top(of), trees(in), most(at_most) {
    for (const Instance& instance : trees.scene->instances) {
      first_triangle.push_back(triangles);
      triangles += trees.scene->objects[instance.object].triangles.size();
    }
    times.resize(triangles);
  }

  std::vector<std::string> run() {
    std::vector<std::uint32_t> leaves(top.references.size());
    const auto leaf = [&](std::uint32_t entry, const Box& box) {
      const std::uint32_t id = top.tree.primitive_ids[entry];
      if ((id & kLastOfLeaf) == 0) add("entry {}: found a leaf of several references, wanted one", entry);
      ++leaves[id & ~kLastOfLeaf];
      reference(id & ~kLastOfLeaf, box);
    };
    if (top.tree.pairs.empty()) leaf(0, top.tree.scene);
    for (std::size_t i = 0; i < top.tree.pairs.size(); ++i) {
      const FloatPair& pair = top.tree.pairs[i];
      for (int c = 0; c < 2; ++c) {
        if (pair.leaf[c]) {
          leaf(pair.pointer[c], pair.child[c]);
        } else if (!is_box(pair.child[c], own_box(top.tree.pairs[pair.pointer[c]]))) {
          add("pair {}, child {}: found a box that is not the one around its children", i, c);
        }
      }
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (leaves[i] != 1) add("reference {}: found in {} leaves, wanted 1", i, leaves[i]);
    }
    for (std::size_t i = 0; i < first_triangle.size(); ++i) {
      const std::size_t last = i + 1 < first_triangle.size() ? first_triangle[i + 1] : triangles;
      for (std::size_t t = first_triangle[i]; t < last; ++t) {
        if (times[t] != 1)
          add("instance {}, triangle {}: found below {} references, wanted 1", i, t - first_triangle[i], times[t]);
      }
    }
    return std::move(found);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> text, Values&&... values) {
    if (found.size() < most) found.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  static bool is_box(const Box& a, const Box& b) { return a.lower == b.lower && a.upper == b.upper; }

  void reference(std::uint32_t id, const Box& box) {
    const SubtreeReference& to = top.references[id];
    const ObjectTree& tree = *trees.trees[trees.scene->instances[to.instance].object];
    std::vector<ObjectNode> open{to.node};
    while (!open.empty()) {
      const ObjectNode node = open.back();
      open.pop_back();
      if (node.kind == Kind::pair) {
        for (const BoxedNode& child : tree.children(node)) open.push_back(child.node);
      } else if (node.kind == Kind::primitive) {
        triangle(to.instance, node.index, id, box);
      } else {
        const std::uint32_t size = leaf_size(tree.primitive_ids(), node.index);
        for (std::uint32_t i = node.index; i < node.index + size; ++i)
          triangle(to.instance, tree.primitive_ids()[i] & ~kLastOfLeaf, id, box);
      }
    }
  }

  void triangle(std::uint32_t instance, std::uint32_t index, std::uint32_t id, const Box& box) {
    const Instance& placed = trees.scene->instances[instance];
    const Mesh& mesh = trees.scene->objects[placed.object];
    ++times[first_triangle[instance] + index];
    for (glm::length_t corner = 0; corner < 3; ++corner) {
      const glm::vec3& position = mesh.positions[mesh.triangles[index][corner]];
      if (!encloses(box, bounds_in_world({position, position}, placed)))
        add("reference {}: found triangle {} of instance {} outside its leaf's box", id, index, instance);
    }
  }

  const TopLevel& top;
  const InstancedTrees& trees;
  std::size_t most;
  std::size_t triangles = 0;
  std::vector<std::size_t> first_triangle;  ///< by instance
  std::vector<std::uint32_t> times;         ///< found below a reference
  std::vector<std::string> found;
};

}  // namespace

std::vector<std::string> faults_of(const TopLevel& top, const InstancedTrees& trees, std::size_t most) {
  return Check(top, trees, most).run();
}

}  // namespace cbvh::golden
