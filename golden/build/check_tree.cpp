// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/check_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <glm/vector_relational.hpp>
#include <iterator>

namespace cbvh::golden {
namespace {

bool same(const Box& a, const Box& b) { return a.lower == b.lower && a.upper == b.upper; }

bool encloses(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
         glm::all(glm::lessThanEqual(inner.upper, outer.upper));
}

class Check {
 public:
  Check(const FloatTree& checked, const Mesh& mesh, std::size_t limit)
      : tree(checked), boxes(triangle_boxes(mesh)), most(limit), seen_in(boxes.size(), kNowhere) {}

  std::vector<std::string> run() {
    shared = tree.primitive_ids.size() > boxes.size();
    if (tree.primitives != boxes.size())
      add(fmt::format("{} primitives, the mesh has {}", tree.primitives, boxes.size()));
    if (tree.leaves != tree.pairs.size() + 1)
      add(fmt::format("{} leaves for {} pairs", tree.leaves, tree.pairs.size()));
    if (!findings.empty()) return findings;
    if (tree.pairs.empty()) {
      check_leaf("root", 0, tree.scene);
    } else {
      check_pairs();
    }
    if (next_entry != tree.primitive_ids.size())
      add(fmt::format("{} entries of primitives, the leaves have {}", tree.primitive_ids.size(), next_entry));
    for (std::size_t id = 0; id < seen_in.size(); ++id) {
      if (seen_in[id] == kNowhere) add(fmt::format("triangle {} is in no leaf", id));
    }
    return findings;
  }

 private:
  static constexpr std::size_t kNowhere = SIZE_MAX;

  void add(std::string what) {
    if (findings.size() < most) findings.push_back(std::move(what));
  }

  /// In emission order a pair's inner children are the last subtrees that nobody has taken yet.
  void check_pairs() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < tree.pairs.size(); ++i) {
      const FloatPair& pair = tree.pairs[i];
      const std::ptrdiff_t inner = (pair.leaf[0] ? 0 : 1) + (pair.leaf[1] ? 0 : 1);
      if (std::ssize(open) < inner) return add(fmt::format("pair {}: its children are not behind it", i));
      auto taken = open.end() - inner;
      for (int c = 0; c < 2; ++c) {
        const std::string place = fmt::format("pair {}, child {}", i, c);
        if (pair.leaf[c]) {
          leaves.push_back({place, pair.pointer[c], pair.child[c]});
          continue;
        }
        if (pair.pointer[c] != *taken)
          return add(fmt::format("{}: pair {}, wanted {}", place, pair.pointer[c], *taken));
        if (!same(pair.child[c], own_box(tree.pairs[*taken])))
          add(place + ": its box is not exactly around its children");
        ++taken;
      }
      open.erase(open.end() - inner, open.end());
      open.push_back(i);
    }
    if (open.size() != 1) add(fmt::format("{} pairs without a parent, wanted the root alone", open.size()));
    if (!same(tree.scene, own_box(tree.pairs.back()))) add("the scene's box is not exactly around the root's children");
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) { return a.first < b.first; });
    for (const Leaf& leaf : leaves) check_leaf(leaf.place, leaf.first, leaf.box);
  }

  void check_leaf(const std::string& place, std::size_t first, const Box& box) {
    if (first != next_entry) return add(fmt::format("{}: its leaf begins at {}, wanted {}", place, first, next_entry));
    Box around{};
    do {
      if (next_entry == tree.primitive_ids.size()) return add(place + ": its leaf has no end");
      const std::uint32_t id = tree.primitive_ids[next_entry] & ~kLastOfLeaf;
      if (id >= boxes.size()) return add(fmt::format("{}: triangle {}, wanted below {}", place, id, boxes.size()));
      if (seen_in[id] == first || (!shared && seen_in[id] != kNowhere))
        add(fmt::format("{}: triangle {} a second time", place, id));
      seen_in[id] = first;
      around = next_entry == first ? boxes[id] : unite(around, boxes[id]);
    } while ((tree.primitive_ids[next_entry++] & kLastOfLeaf) == 0);
    if (shared ? !encloses(around, box) : !same(around, box))
      add(fmt::format("{}: its box is not {} its triangles'", place, shared ? "within" : "exactly"));
  }

  struct Leaf {
    std::string place;
    std::uint32_t first;
    Box box;
  };

  const FloatTree& tree;
  const std::vector<Box> boxes;
  const std::size_t most;
  std::vector<std::string> findings;
  std::vector<Leaf> leaves;
  std::vector<std::size_t> seen_in;  ///< of each triangle: the last leaf it was found in
  std::size_t next_entry = 0;
  bool shared = false;
};

}  // namespace

std::vector<std::string> check_tree(const FloatTree& tree, const Mesh& mesh, std::size_t most) {
  return Check(tree, mesh, most).run();
}

}  // namespace cbvh::golden
