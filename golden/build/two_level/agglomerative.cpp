// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/agglomerative.h"

#include "golden/build/node_tree.h"
#include "golden/build/two_level/pair_search.h"
#include "golden/build/two_level/reference_tree.h"

namespace cbvh::golden {
namespace {

template <class Search>
std::vector<Pairing> cluster(std::span<const Box> boxes) {
  std::vector<Pairing> pairings;
  auto count = static_cast<std::uint32_t>(boxes.size());
  if (count < 2) return pairings;
  pairings.reserve(count - 1);
  Search search(boxes);
  std::uint32_t a = 0;
  std::uint32_t b = search.best_match(a);
  while (true) {
    const std::uint32_t c = search.best_match(b);
    if (a != c) {
      a = b;
      b = c;
      continue;
    }
    pairings.push_back({a, b});
    search.merge(a, b);
    --count;
    if (count == 1) return pairings;
    if (a == count) a = b;
    b = search.best_match(a);
  }
}

NodeTree to_tree(std::span<const BuildReference> references, std::span<const Pairing> pairings) {
  NodeTree tree;
  tree.nodes.resize(2 * references.size() - 1);
  std::vector<NodeTree::Node> open;
  open.reserve(references.size());
  for (std::uint32_t i = 0; i < references.size(); ++i) {
    open.push_back({narrowed(references[i].bounds), i, 1});
    tree.references.push_back(i);
  }
  std::uint32_t next = 1;
  for (const auto& [a, b] : pairings) {
    tree.nodes[next] = open[a];
    tree.nodes[next + 1] = open[b];
    open[a] = {unite(open[a].box, open[b].box), next, 0};
    open[b] = open.back();
    open.pop_back();
    next += 2;
  }
  tree.nodes[0] = open[0];
  return tree;
}

TopLevel build(const InstancedTrees& trees, const OptionValues& options) {
  const std::vector<BuildReference> references = whole_instances(trees);
  std::vector<Box> boxes;
  boxes.reserve(references.size());
  for (const BuildReference& reference : references) boxes.push_back(narrowed(reference.bounds));
  const auto search = options.word("search") == 0 ? PairSearch::tree : PairSearch::scan;
  return emit_references(to_tree(references, nearest_pairings(boxes, search)), references, trees.scene->name);
}

}  // namespace

std::vector<Pairing> nearest_pairings(std::span<const Box> boxes, PairSearch search) {
  return search == PairSearch::tree ? cluster<TreeSearch>(boxes) : cluster<ScanSearch>(boxes);
}

TopLevelKind agglomerative_top_level() {
  return {"agglomerative",
          "pairs of instances that are each other's nearest, bottom up (Bikker, part 6)",
          {word_option("search", "how the nearest is found; the tree is the same", {"tree", "scan"})},
          build};
}

}  // namespace cbvh::golden
