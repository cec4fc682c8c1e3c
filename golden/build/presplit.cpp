// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/presplit.h"

#include <utility>

#include "golden/build/node_tree.h"
#include "golden/build/sweep.h"

namespace cbvh::golden {

FloatTree sweep_pieces(const std::vector<Piece>& pieces, const Mesh& mesh, const OptionValues& options) {
  check_counts(mesh.name, pieces.size(), 0);
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const Piece& piece : pieces) boxes.push_back(piece.box);
  NodeTree tree = sweep_tree(boxes, build_limits(options, pieces.size(), mesh.name));
  const auto references = std::move(tree.references);
  tree.references = {};
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    NodeTree::Node& node = tree.nodes[open.back()];
    open.pop_back();
    if (node.count == 0) {
      open.insert(open.end(), {node.first + 1, node.first});
      continue;
    }
    const auto first = static_cast<std::uint32_t>(tree.references.size());
    for (std::uint32_t entry = node.first; entry < node.first + node.count; ++entry) {
      const std::uint32_t id = pieces[references[entry]].id;
      if (tree.references.size() == first || tree.references.back() != id) tree.references.push_back(id);
    }
    node.first = first;
    node.count = static_cast<std::uint32_t>(tree.references.size()) - first;
  }
  return emit(tree, mesh.triangles.size(), mesh.name);
}

}  // namespace cbvh::golden
