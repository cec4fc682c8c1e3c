// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/refit.h"

#include <algorithm>

#include "golden/build/triangle_box.h"
#include "golden/input_error.h"
#include "golden/scene/mesh_check.h"
#include "golden/threads/parallel_for.h"

namespace cbvh::golden {
namespace {

/// Subtrees a thread: enough to share the work out evenly however different they are.
constexpr std::size_t kSubtreesPerThread = 16;

/// Smaller ones are not worth a thread's while.
constexpr std::uint32_t kSmallestSubtree = 256;

/// Pairs first to last (one behind): a subtree, because emission is depth first and bottom up.
struct Subtree {
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t size() const { return last - first; }
};

class Refit {
 public:
  Refit(FloatTree& to_refit, const Mesh& moved) : tree(to_refit), mesh(moved) {}

  void pairs(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) {  // children come before their parents
      FloatPair& pair = tree.pairs[i];
      for (int c = 0; c < 2; ++c)
        pair.child[c] = pair.leaf[c] ? leaf_box(pair.pointer[c]) : own_box(tree.pairs[pair.pointer[c]]);
    }
  }

  void scene() {
    tree.scene = tree.pairs.empty() ? leaf_box(0) : own_box(tree.pairs.back());
    tree.largest_magnitude = largest_magnitude(tree.scene);
  }

 private:
  Box box_of(std::size_t entry) const {
    const glm::uvec3& triangle = mesh.triangles[tree.primitive_ids[entry] & ~kLastOfLeaf];
    return triangle_box(mesh.positions[triangle.x], mesh.positions[triangle.y], mesh.positions[triangle.z]);
  }

  Box leaf_box(std::size_t entry) const {
    Box box = box_of(entry);
    while ((tree.primitive_ids[entry] & kLastOfLeaf) == 0) box = unite(box, box_of(++entry));
    return box;
  }

  FloatTree& tree;
  const Mesh& mesh;
};

/// The tree cut into whole subtrees of at most `most` pairs, and the pairs above them in rising order.
struct Cut {
  std::vector<Subtree> subtrees;
  std::vector<std::uint32_t> top;
};

/// The subtree of pair p ends with p; it begins where the pair before its first child's subtree ends. Child 0 comes
/// before child 1, so the bounds follow on the way down.
Cut cut_tree(const FloatTree& tree, std::uint32_t most) {
  Cut cut;
  std::vector<Subtree> open{{0, static_cast<std::uint32_t>(tree.pairs.size())}};
  while (!open.empty()) {
    const Subtree subtree = open.back();
    open.pop_back();
    if (subtree.size() <= most) {
      if (subtree.size() > 0) cut.subtrees.push_back(subtree);
      continue;
    }
    const std::uint32_t root = subtree.last - 1;
    cut.top.push_back(root);
    const FloatPair& pair = tree.pairs[root];
    const std::uint32_t middle = pair.leaf[0] ? subtree.first : pair.pointer[0] + 1;
    open.push_back({subtree.first, middle});
    open.push_back({middle, root});
  }
  std::sort(cut.subtrees.begin(), cut.subtrees.end(),
            [](const Subtree& a, const Subtree& b) { return a.size() > b.size(); });
  std::sort(cut.top.begin(), cut.top.end());
  return cut;
}

}  // namespace

void refit_in_place(FloatTree& tree, const Mesh& mesh, unsigned threads) {
  check_mesh(mesh, mesh.name);
  if (mesh.triangles.size() != tree.primitives) {
    throw InputError(mesh.name,
                     fmt::format("{} triangles, the tree to refit has {}", mesh.triangles.size(), tree.primitives));
  }
  Refit work(tree, mesh);
  const auto pairs = static_cast<std::uint32_t>(tree.pairs.size());
  if (threads <= 1) {
    work.pairs(0, pairs);
  } else {
    const auto share = static_cast<std::uint32_t>(tree.pairs.size() / (threads * kSubtreesPerThread));
    const Cut cut = cut_tree(tree, std::max(share, kSmallestSubtree));
    parallel_for(cut.subtrees.size(), threads,
                 [&](std::size_t i) { work.pairs(cut.subtrees[i].first, cut.subtrees[i].last); });
    for (const std::uint32_t pair : cut.top) work.pairs(pair, pair + 1);
  }
  work.scene();
}

FloatTree refit(FloatTree tree, const Mesh& mesh) {
  refit_in_place(tree, mesh, 1);
  return tree;
}

}  // namespace cbvh::golden
