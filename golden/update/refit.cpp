// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/refit.h"

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

Box leaf_box(const FloatTree& tree, const std::vector<Box>& boxes, std::size_t entry) {
  Box box = boxes[tree.primitive_ids[entry] & ~kLastOfLeaf];
  while ((tree.primitive_ids[entry] & kLastOfLeaf) == 0) {
    ++entry;
    box = unite(box, boxes[tree.primitive_ids[entry] & ~kLastOfLeaf]);
  }
  return box;
}

}  // namespace

FloatTree refit(FloatTree tree, const Mesh& mesh) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  if (boxes.size() != tree.primitives) {
    throw InputError(mesh.name, fmt::format("{} triangles, the tree to refit has {}", boxes.size(), tree.primitives));
  }
  for (FloatPair& pair : tree.pairs) {  // children come before their parents
    for (int c = 0; c < 2; ++c) {
      pair.child[c] = pair.leaf[c] ? leaf_box(tree, boxes, pair.pointer[c]) : own_box(tree.pairs[pair.pointer[c]]);
    }
  }
  tree.scene = tree.pairs.empty() ? leaf_box(tree, boxes, 0) : own_box(tree.pairs.back());
  tree.largest_magnitude = largest_magnitude(tree.scene);
  return tree;
}

}  // namespace cbvh::golden
