// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/validate.h"

#include <fmt/format.h>

#include <cmath>

#include "golden/input_error.h"
#include "golden/tree/pair_codec.h"

namespace cbvh::golden {
namespace {

using Where = Violation::Where;

/// Collects violations up to a limit.
class Findings {
 public:
  explicit Findings(std::size_t limit) : most(limit) {}
  void add(Where where, std::uint32_t index, int child, std::string what) {
    if (list.size() < most) list.push_back({where, index, child, std::move(what)});
  }
  void add(const std::string& what) { add(Where::header, 0, -1, what); }

  std::vector<Violation> list;

 private:
  std::size_t most;
};

/// The primitive-ID array: which entries a leaf has claimed.
class LeafEntries {
 public:
  LeafEntries(const CompressedTree& compressed, Findings& out)
      : tree(compressed), findings(out), claimed(tree.primitive_ids.size()) {}

  void claim(std::uint32_t pair, int child, std::uint32_t first) {
    for (std::size_t entry = first;; ++entry) {
      if (entry >= claimed.size()) {
        findings.add(Where::pair, pair, child,
                     fmt::format("leaf runs past the {} primitive IDs, from {}", claimed.size(), first));
        return;
      }
      if (claimed[entry]) {
        findings.add(Where::pair, pair, child, fmt::format("leaf overlaps another at primitive-ID entry {}", entry));
        return;
      }
      claimed[entry] = true;
      if ((tree.primitive_ids[entry] & kLastOfLeaf) != 0) return;
    }
  }

  void check_all_claimed() {
    for (std::size_t entry = 0; entry < claimed.size(); ++entry) {
      if (!claimed[entry])
        findings.add(Where::primitive_id, static_cast<std::uint32_t>(entry), -1, "no leaf reaches this entry");
    }
  }

  /// Every primitive is there, and none a second time: in its leaf or, if there are no more entries than primitives,
  /// anywhere.
  void check_ids() {
    const bool shared = tree.primitive_ids.size() > tree.primitives;
    constexpr std::size_t kNowhere = SIZE_MAX;
    std::vector<std::size_t> seen_in(tree.primitives, kNowhere);
    std::size_t leaf = 0;  // its first entry
    for (std::size_t entry = 0; entry < tree.primitive_ids.size(); ++entry) {
      const std::uint32_t id = tree.primitive_ids[entry] & ~kLastOfLeaf;
      if (id >= tree.primitives) {
        add(entry, fmt::format("primitive {}, want below {}", id, tree.primitives));
      } else if (seen_in[id] == leaf || (!shared && seen_in[id] != kNowhere)) {
        add(entry, fmt::format("primitive {} a second time", id));
      } else {
        seen_in[id] = leaf;
      }
      if ((tree.primitive_ids[entry] & kLastOfLeaf) != 0) leaf = entry + 1;
    }
    if (!shared) return;  // then a missing one shows as another's second time
    for (std::uint32_t id = 0; id < tree.primitives; ++id) {
      if (seen_in[id] == kNowhere) findings.add(fmt::format("primitive {} is in no leaf", id));
    }
  }

 private:
  void add(std::size_t entry, std::string what) {
    findings.add(Where::primitive_id, static_cast<std::uint32_t>(entry), -1, std::move(what));
  }

  const CompressedTree& tree;
  Findings& findings;
  std::vector<bool> claimed;
};

template <class Index>
class Walk {
 public:
  Walk(const CompressedTree& compressed, const FloatTree* float_tree, Findings& out)
      : tree(compressed),
        floats(float_tree),
        findings(out),
        entries(compressed, out),
        reached(compressed.pairs.size()) {}

  void run() {
    entries.check_ids();
    if (tree.pairs.empty()) {
      entries.claim(0, -1, 0);
    } else {
      const Context<Index> root = root_context<Index>(tree.scene, tree.rules);
      std::array<Index, 3> upper;
      const CellBox<Index> cells = encode_cells(tree.scene, root);
      for (std::size_t axis = 0; axis < 3; ++axis) upper[axis] = cells[axis].upper;
      reach({static_cast<std::uint32_t>(tree.pairs.size() - 1), root, upper});
      while (!open.empty()) {
        const Node node = open.back();
        open.pop_back();
        check(node);
      }
    }
    if (!complete) return;  // part of the tree could not be walked: what it hides is not a finding of its own
    for (std::size_t pair = 0; pair < reached.size(); ++pair) {
      if (!reached[pair]) findings.add(Where::pair, static_cast<std::uint32_t>(pair), -1, "not reached from the root");
    }
    entries.check_all_claimed();
  }

 private:
  /// A node with children: its pair, its own grid and its own upper index on it.
  struct Node {
    std::uint32_t pair;
    Context<Index> context;
    std::array<Index, 3> upper;
  };

  void reach(const Node& node) {
    reached[node.pair] = true;
    open.push_back(node);
  }

  void check(const Node& node) {
    const CompressedPair& pair = tree.pairs[node.pair];
    for (int c = 0; c < 2; ++c) {
      const CompressedChild& child = pair.child[c];
      const CellBox<Index> cells = decode_codes(child.codes, node.context, tree.code, tree.rules.bits);
      bool sound = true;
      for (int axis = 0; axis < 3; ++axis) sound &= check_axis(node, c, axis, cells[static_cast<std::size_t>(axis)]);
      if (floats != nullptr) check_enclosure(node, c, cells);
      if (child.leaf) {
        entries.claim(node.pair, c, child.pointer);
      } else if (child.pointer >= tree.pairs.size()) {
        findings.add(Where::pair, node.pair, c,
                     fmt::format("pointer {}, want below {}", child.pointer, tree.pairs.size()));
        complete = false;
      } else if (reached[child.pointer]) {
        findings.add(
            Where::pair, node.pair, c,
            fmt::format("pointer {} leads to a pair reached before: a cycle or a shared subtree", child.pointer));
        complete = false;
      } else if (!sound) {
        complete = false;
      } else {
        reach(child_of(node, child.pointer, cells));
      }
    }
  }

  Node child_of(const Node& node, std::uint32_t pair, const CellBox<Index>& cells) const {
    Node child{pair, child_context(cells, node.context, tree.rules), {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      child.upper[axis] = times_power_of_two(cells[axis].upper, node.context[axis].scale - child.context[axis].scale);
    }
    return child;
  }

  bool check_axis(const Node& node, int c, int axis, const Cells<Index>& cells) {
    const auto a = static_cast<std::size_t>(axis);
    const AxisCodes codes = tree.pairs[node.pair].child[c].codes[a];
    const auto fail = [&](const std::string& what) {
      findings.add(Where::pair, node.pair, c,
                   fmt::format("axis {}: codes {} {}: {}", "xyz"[a], codes.lower, codes.upper, what));
      return false;
    };
    if ((codes.lower >> tree.rules.bits) != 0 || (codes.upper >> tree.rules.bits) != 0) {
      return fail(fmt::format("want {} bits", tree.rules.bits));
    }
    if (cells.upper <= cells.lower) return fail("the upper edge is not above the lower one");
    if (cells.upper > node.upper[a])
      return fail("the box reaches outside its parent's");  // cells.lower cannot: it decodes upwards
    if (cells.upper - cells.lower > tree.rules.max_cells()) return fail("the box spans too many cells");
    return true;
  }

  void check_enclosure(const Node& node, int c, const CellBox<Index>& cells) {
    const CompressedChild& child = tree.pairs[node.pair].child[c];
    const FloatPair& pair = floats->pairs[node.pair];
    if (child.leaf != pair.leaf[c] || child.pointer != pair.pointer[c]) {
      findings.add(Where::pair, node.pair, c, "leaf bit or pointer differs from the float tree's");
      return;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const int scale = node.context[a].scale;
      if (cells[a].lower > floor_on_grid<Index>(pair.child[c].lower[axis], scale) ||
          cells[a].upper < ceil_on_grid<Index>(pair.child[c].upper[axis], scale)) {
        findings.add(Where::pair, node.pair, c,
                     fmt::format("axis {}: the quantized box does not enclose the float one", "xyz"[a]));
      }
    }
  }

  const CompressedTree& tree;
  const FloatTree* floats;
  Findings& findings;
  LeafEntries entries;
  std::vector<bool> reached;
  std::vector<Node> open;
  bool complete = true;
};

void check_header(const CompressedTree& tree, Findings& findings) {
  try {
    check_rules(tree.rules);
    check_counts("counts", tree.primitive_ids.size(), tree.pairs.size());
  } catch (const InputError& error) {
    findings.add(error.what());
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const float lower = tree.scene.lower[axis];
    const float upper = tree.scene.upper[axis];
    if (!std::isfinite(lower) || !std::isfinite(upper) || !(lower <= upper)) {
      findings.add(fmt::format("scene box, axis {}: {} .. {}, want finite bounds in order", "xyz"[axis], lower, upper));
      return;
    }
  }
  if (tree.root != root_context<Wide>(tree.scene, tree.rules)) findings.add("the root's grid is not the scene box's");
  if (tree.primitives == 0) findings.add("no primitives");
  if (tree.primitive_ids.size() < tree.primitives) {
    findings.add(fmt::format("{} primitive IDs for {} primitives", tree.primitive_ids.size(), tree.primitives));
  }
  if (tree.leaves != tree.pairs.size() + 1)
    findings.add(fmt::format("{} leaves for {} pairs", tree.leaves, tree.pairs.size()));
}

std::vector<Violation> run(const CompressedTree& tree, const FloatTree* floats, std::size_t most) {
  Findings findings(most);
  check_header(tree, findings);
  if (floats != nullptr && floats->pairs.size() != tree.pairs.size()) {
    findings.add(fmt::format("{} pairs, the float tree has {}", tree.pairs.size(), floats->pairs.size()));
  }
  if (!findings.list.empty()) return findings.list;
  if (fits_64_bits(tree.scene, tree.rules)) {
    Walk<std::int64_t>(tree, floats, findings).run();
  } else {
    Walk<Wide>(tree, floats, findings).run();
  }
  return findings.list;
}

}  // namespace

std::string to_string(const Violation& violation) {
  switch (violation.where) {
    case Where::header:
      return violation.what;
    case Where::primitive_id:
      return fmt::format("primitive-ID entry {}: {}", violation.index, violation.what);
    case Where::pair:
      break;
  }
  return violation.child < 0 ? fmt::format("pair {}: {}", violation.index, violation.what)
                             : fmt::format("pair {}, child {}: {}", violation.index, violation.child, violation.what);
}

std::vector<Violation> validate(const CompressedTree& tree, std::size_t most) { return run(tree, nullptr, most); }

std::vector<Violation> validate(const CompressedTree& tree, const FloatTree& floats, std::size_t most) {
  return run(tree, &floats, most);
}

}  // namespace cbvh::golden
