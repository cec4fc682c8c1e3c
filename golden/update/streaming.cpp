// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/streaming.h"

#include <stdexcept>
#include <type_traits>

#include "golden/input_error.h"
#include "golden/tree/pair_codec.h"

namespace cbvh::golden {
namespace {

template <class Index>
class Streamer {
 public:
  Streamer(const FloatTree& floats, StreamingResult& result, int levels, const StreamingObserver* watcher)
      : tree(floats),
        out(result.tree),
        counts(result.counts),
        treelet_levels(levels),
        observer(watcher),
        contexts(floats.pairs.size()) {}

  void run() {
    for (std::uint32_t arriving = 0; arriving < tree.pairs.size(); ++arriving) {
      finalise_level(arriving, root_context<Index>(own_box(tree.pairs[arriving]), out.rules), 1);
    }
    const auto root = static_cast<std::uint32_t>(tree.pairs.size() - 1);
    flush(root, root_context<Index>(tree.scene, out.rules), 1);
  }

 private:
  struct Repair {
    std::uint32_t pair;
    Context<Index> from;
    Context<Index> to;
    std::size_t depth;
  };

  /// Compresses top-down to the treelet's last level, whose pairs become final (rule 10).
  void finalise_level(std::uint32_t index, const Context<Index>& context, int level) {
    const FloatPair& pair = tree.pairs[index];
    const PairCells<Index> cells = encode_cells(pair, context);
    if (level == treelet_levels) write(index, cells, context);
    for (std::size_t c = 0; c < 2; ++c) {
      if (pair.leaf[c]) continue;
      const Context<Index> child = child_context(cells[c], context, out.rules);
      if (level < treelet_levels) {
        finalise_level(pair.pointer[c], child, level + 1);
      } else if (is_invalid(contexts[pair.pointer[c]], child)) {
        backtrack({pair.pointer[c], contexts[pair.pointer[c]], child, static_cast<std::size_t>(treelet_levels)});
      }
    }
  }

  /// Writes what the last arrival left: the treelet of the root but for its last level.
  void flush(std::uint32_t index, const Context<Index>& context, int level) {
    if (level == treelet_levels) return;
    const FloatPair& pair = tree.pairs[index];
    const PairCells<Index> cells = encode_cells(pair, context);
    write(index, cells, context);
    for (std::size_t c = 0; c < 2; ++c) {
      if (!pair.leaf[c]) flush(pair.pointer[c], child_context(cells[c], context, out.rules), level + 1);
    }
  }

  void write(std::uint32_t index, const PairCells<Index>& cells, const Context<Index>& context) {
    out.pairs[index] = compress_pair(tree.pairs[index], cells, context, out.code, out.rules.bits);
    contexts[index] = context;
    if constexpr (std::is_same_v<Index, std::int64_t>) {
      if (observer != nullptr && observer->on_final) observer->on_final(index, out.pairs[index], context);
    }
  }

  /// Rule 9.
  bool is_invalid(const Context<Index>& old_context, const Context<Index>& new_context) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (old_context[axis].scale != new_context[axis].scale) return true;
      if (out.code == Code::relative && old_context[axis].lower != new_context[axis].lower) return true;
    }
    return false;
  }

  /// Repairs a pair written before and, where that changes their contexts, the pairs below it (rules 7 and 9).
  void backtrack(const Repair& first) {
    pending.push_back(first);
    while (!pending.empty()) {
      const Repair repair = pending.back();
      pending.pop_back();
      const CompressedPair old_pair = out.pairs[repair.pair];
      const PairCells<Index> old_cells = decode_codes(old_pair, repair.from, out.code, out.rules.bits);
      const PairCells<Index> new_cells{coarsen_box(old_cells[0], repair), coarsen_box(old_cells[1], repair)};
      CompressedPair& new_pair = out.pairs[repair.pair];
      for (std::size_t c = 0; c < 2; ++c) {
        new_pair.child[c].codes = encode_codes(new_cells[c], repair.to, out.code, out.rules.bits);
      }
      count(repair.depth);
      if constexpr (std::is_same_v<Index, std::int64_t>) {
        if (observer != nullptr && observer->on_repair) {
          observer->on_repair(repair.pair, old_pair, new_pair, repair.from, repair.to);
        }
      }
      for (const std::size_t c : {std::size_t{1}, std::size_t{0}}) {  // child 0 ends on top
        if (new_pair.child[c].leaf) continue;
        const Context<Index> from = child_context(old_cells[c], repair.from, out.rules);
        const Context<Index> to = child_context(new_cells[c], repair.to, out.rules);
        if (is_invalid(from, to)) pending.push_back({new_pair.child[c].pointer, from, to, repair.depth + 1});
      }
    }
  }

  static CellBox<Index> coarsen_box(const CellBox<Index>& cells, const Repair& repair) {
    CellBox<Index> coarse;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int d = repair.to[axis].scale - repair.from[axis].scale;
      if (d < 0) throw std::logic_error("streaming: an estimated scale exceeded the true one");
      coarse[axis] = coarsen(cells[axis], d);
    }
    return coarse;
  }

  void count(std::size_t depth) {
    ++counts.backtracks;
    if (counts.depth_histogram.size() <= depth) counts.depth_histogram.resize(depth + 1);
    ++counts.depth_histogram[depth];
  }

  const FloatTree& tree;
  CompressedTree& out;
  StreamingCounts& counts;
  int treelet_levels;
  const StreamingObserver* observer;
  std::vector<Context<Index>> contexts;  ///< of each final pair, as it was when the pair was written
  std::vector<Repair> pending;
};

}  // namespace

StreamingResult compress_streaming(const FloatTree& tree, const GridRules& rules, Code code, int treelet_levels,
                                   const StreamingObserver* observer) {
  if (treelet_levels < 1 || treelet_levels > 16) {
    throw InputError("treelet", fmt::format("found {}, want 1..16", treelet_levels));
  }
  StreamingResult result{blank_compressed_tree(tree, rules, code), {}};
  const bool narrow = fits_64_bits(tree.scene, rules);
  if (observer != nullptr && !narrow) {
    throw InputError("min-scale", fmt::format("found {}, want at least {} (the exactness limit)", rules.min_scale,
                                              exactness_limit(tree.largest_magnitude)));
  }
  if (tree.pairs.empty()) return result;
  if (narrow) {
    Streamer<std::int64_t>(tree, result, treelet_levels, observer).run();
  } else {
    Streamer<Wide>(tree, result, treelet_levels, observer).run();
  }
  return result;
}

}  // namespace cbvh::golden
