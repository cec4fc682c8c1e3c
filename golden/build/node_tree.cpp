// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/node_tree.h"

#include <algorithm>
#include <utility>

#include "golden/threads/parallel_for.h"

namespace cbvh::golden {
namespace {

/// What a pair says of one of its children.
struct Emitted {
  Box box;
  bool leaf;
  std::uint32_t pointer;
};

/// A subtree emitted on its own, as if it were a tree: `root` and all pointers count from its own beginning.
struct Part {
  std::uint32_t node = 0;
  std::vector<FloatPair> pairs;
  std::vector<std::uint32_t> ids;
  Emitted root{};
  std::uint32_t first_pair = 0;  ///< where its pairs and IDs go in the whole tree
  std::uint32_t first_id = 0;
};

/// `emitted` where pairs and IDs before it are not its own.
Emitted moved(Emitted emitted, std::uint32_t first_pair, std::uint32_t first_id) {
  emitted.pointer += emitted.leaf ? first_id : first_pair;
  return emitted;
}

/// Post-order over the nodes with a stack of our own: a node is opened, its children are emitted, then its pair.
class Walk {
 public:
  explicit Walk(const NodeTree& tree) : tree_(tree) {}

  /// Emits all below a node that is_whole(node) does not take. Calls leaf(node) or whole(node) for the ends of its
  /// ways, and pair(left, right) after both children; each returns an Emitted.
  template <class IsWhole, class Whole, class Leaf, class Pair>
  Emitted run(std::uint32_t root, const IsWhole& is_whole, const Whole& whole, const Leaf& leaf, const Pair& pair) {
    open_.push_back({root, false});
    while (!open_.empty()) {
      const Visit visit = open_.back();
      open_.pop_back();
      const NodeTree::Node& node = tree_.nodes[visit.node];
      if (is_whole(visit.node)) {
        done_.push_back(whole(visit.node));
      } else if (node.count > 0) {
        done_.push_back(leaf(node));
      } else if (visit.children_done) {
        const Emitted right = done_.back();
        done_.pop_back();
        done_.back() = pair(done_.back(), right);
      } else {
        open_.push_back({visit.node, true});
        open_.push_back({node.first + 1, false});
        open_.push_back({node.first, false});
      }
    }
    return done_.back();
  }

 private:
  struct Visit {
    std::uint32_t node;
    bool children_done;
  };
  const NodeTree& tree_;
  std::vector<Visit> open_;
  std::vector<Emitted> done_;
};

FloatPair pair_of(const Emitted& left, const Emitted& right) {
  return {{left.box, right.box}, {left.leaf, right.leaf}, {left.pointer, right.pointer}};
}

void emit_part(const NodeTree& tree, Part& part) {
  const auto leaf = [&](const NodeTree::Node& node) {
    const auto first = static_cast<std::uint32_t>(part.ids.size());
    const auto from = tree.references.begin() + node.first;
    part.ids.insert(part.ids.end(), from, from + node.count);
    part.ids.back() |= kLastOfLeaf;
    return Emitted{node.box, true, first};
  };
  const auto pair = [&](const Emitted& left, const Emitted& right) {
    part.pairs.push_back(pair_of(left, right));
    return Emitted{unite(left.box, right.box), false, static_cast<std::uint32_t>(part.pairs.size() - 1)};
  };
  const auto none = [](std::uint32_t) { return false; };
  part.root = Walk(tree).run(
      part.node, none, [](std::uint32_t) { return Emitted{}; }, leaf, pair);
}

/// The roots of about that many subtrees, level by level: all leaves of the tree lie below or in them.
std::vector<Part> parts_of(const NodeTree& tree, std::size_t count) {
  std::vector<std::uint32_t> roots{0};
  for (bool grows = true; grows && roots.size() < count;) {
    grows = false;
    std::vector<std::uint32_t> next;
    for (const std::uint32_t root : roots) {
      const NodeTree::Node& node = tree.nodes[root];
      if (node.count > 0) {
        next.push_back(root);
      } else {
        next.insert(next.end(), {node.first, node.first + 1});
        grows = true;
      }
    }
    roots = std::move(next);
  }
  std::vector<Part> parts(roots.size());
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].node = roots[i];
  return parts;  // from left to right
}

/// The top of the tree over parts in their order, then all of it in one place.
Box join(const NodeTree& tree, std::vector<Part>& parts, int threads, FloatTree& result) {
  struct Placed {
    std::uint32_t index;
    FloatPair pair;
  };
  std::vector<Placed> top;
  std::size_t next = 0;
  std::uint32_t pairs = 0;
  std::uint32_t ids = 0;
  const auto is_part = [&](std::uint32_t node) { return next < parts.size() && parts[next].node == node; };
  const auto part = [&](std::uint32_t) {
    Part& here = parts[next++];
    here.first_pair = std::exchange(pairs, pairs + static_cast<std::uint32_t>(here.pairs.size()));
    here.first_id = std::exchange(ids, ids + static_cast<std::uint32_t>(here.ids.size()));
    return moved(here.root, here.first_pair, here.first_id);
  };
  const auto pair = [&](const Emitted& left, const Emitted& right) {
    top.push_back({pairs, pair_of(left, right)});
    return Emitted{unite(left.box, right.box), false, pairs++};
  };
  const Emitted root = Walk(tree).run(
      0, is_part, part, [](const NodeTree::Node&) { return Emitted{}; }, pair);
  result.pairs.resize(pairs);
  result.primitive_ids.resize(ids);
  for (const Placed& placed : top) result.pairs[placed.index] = placed.pair;
  parallel_for(parts.size(), static_cast<unsigned>(threads), [&](std::size_t i) {
    const Part& from = parts[i];
    std::copy(from.ids.begin(), from.ids.end(), result.primitive_ids.begin() + from.first_id);
    FloatPair* to = result.pairs.data() + from.first_pair;
    for (const FloatPair& local : from.pairs) {
      *to = local;
      for (int c = 0; c < 2; ++c) to->pointer[c] += local.leaf[c] ? from.first_id : from.first_pair;
      ++to;
    }
  });
  return root.box;
}

/// Parts a thread: enough to share the work out evenly however different they are.
constexpr int kPartsPerThread = 32;

}  // namespace

FloatTree emit(const NodeTree& tree, std::size_t primitives, const std::string& place, int threads) {
  check_counts(place, tree.references.size(), tree.nodes.size() / 2);
  FloatTree result;
  result.primitives = static_cast<std::uint32_t>(primitives);
  std::vector<Part> parts = parts_of(tree, threads == 1 ? 1 : static_cast<std::size_t>(kPartsPerThread * threads));
  if (parts.size() == 1) {
    parts[0].ids.reserve(tree.references.size());
    parts[0].pairs.reserve(tree.nodes.size() / 2);
    emit_part(tree, parts[0]);
    result.pairs = std::move(parts[0].pairs);
    result.primitive_ids = std::move(parts[0].ids);
    result.scene = parts[0].root.box;
  } else {
    parallel_for(parts.size(), static_cast<unsigned>(threads), [&](std::size_t i) { emit_part(tree, parts[i]); });
    result.scene = join(tree, parts, threads, result);
  }
  result.leaves = static_cast<std::uint32_t>(result.pairs.size() + 1);
  result.largest_magnitude = largest_magnitude(result.scene);
  return result;
}

int depth(const FloatTree& tree) {
  std::vector<int> below(tree.pairs.size());
  for (std::size_t pair = 0; pair < tree.pairs.size(); ++pair) {
    for (int c = 0; c < 2; ++c) {
      if (!tree.pairs[pair].leaf[c]) below[pair] = std::max(below[pair], below[tree.pairs[pair].pointer[c]]);
    }
    ++below[pair];
  }
  return below.empty() ? 0 : below.back();
}

}  // namespace cbvh::golden
