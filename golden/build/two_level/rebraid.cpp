// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/rebraid.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "golden/build/build_limits.h"
#include "golden/build/object_median.h"
#include "golden/build/sah_bins.h"
#include "golden/build/two_level/segment_queue.h"
#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

/// What a thread needs again and again.
struct Scratch {
  std::vector<std::uint32_t> chosen;
  std::vector<BuildReference> children;
};

class Rebraid {
 public:
  Rebraid(const InstancedTrees& trees, const RebraidOptions& options, const SegmentObserver& observer)
      : options_(options),
        opener_(trees, options.width, options.open_leaves),
        observer_(observer),
        array_(whole_instances(trees)) {
    limits_.leaf = 1;
    limits_.depth = options.depth;
    const auto count = static_cast<std::uint32_t>(array_.size());
    if (!limits_.fit(count, limits_.depth))
      throw InputError(
          trees.scene->name,
          fmt::format("{} instances do not fit {} levels of inner nodes, want more depth", count, limits_.depth));
    const auto places = static_cast<std::uint32_t>(std::max<std::uint64_t>(options.places, count));
    array_.resize(places);
    tree_.nodes.resize(2 * std::size_t{places} - 1);
    tree_.references.resize(places);
    std::iota(tree_.references.begin(), tree_.references.end(), 0);
    const Segment whole{0, count, places, 0, limits_.depth, places > count, bounds(0, count)};
    run_segments(whole, options.threads, [this] {
      return [this, scratch = Scratch()](const Segment& segment) mutable { return build(segment, scratch); };
    });
  }

  const NodeTree& tree() const { return tree_; }
  const std::vector<BuildReference>& array() const { return array_; }

 private:
  std::span<BuildReference> references(std::uint32_t first, std::uint32_t last) {
    return std::span(array_).subspan(first, last - first);
  }

  WideBox bounds(std::uint32_t first, std::uint32_t last) {
    WideBox box;
    for (const BuildReference& reference : references(first, last)) box.enclose(reference.bounds);
    return box;
  }

  /// A leaf, or an inner node and its two segments.
  std::optional<std::array<Segment, 2>> build(Segment segment, Scratch& scratch) {
    if (observer_) observer_(segment, references(segment.first, segment.last));
    if (segment.count() == 1) {
      tree_.nodes[segment.node] = {narrowed(array_[segment.first].bounds), segment.first, 1};
      return std::nullopt;
    }
    if (segment.opening && !options_.rule.ends(references(segment.first, segment.last), segment.bounds)) {
      open(segment, scratch);
    } else {
      segment.opening = false;
    }
    segment.opening = segment.opening && segment.space() > 0;
    const std::uint32_t middle = segment.first + partition(segment);
    std::array<Segment, 2> halves{
        Segment{segment.first, middle, middle, 0, segment.levels - 1, segment.opening, {}},
        Segment{middle, segment.last, segment.end, 0, segment.levels - 1, segment.opening, {}}};
    if (segment.opening) share_space(halves);
    // Each border between two segments is a border once: nodes 2b - 1 and 2b are its own.
    const std::uint32_t border = halves[1].first;
    halves[0].node = 2 * border - 1;
    halves[1].node = 2 * border;
    tree_.nodes[segment.node] = {{}, halves[0].node, 0};
    return halves;
  }

  /// Opens what the rule chooses while there is space, and while the levels left can hold the references.
  void open(Segment& segment, Scratch& scratch) {
    options_.rule.choose(references(segment.first, segment.last), segment.bounds, opener_, scratch.chosen);
    for (const std::uint32_t index : scratch.chosen) {
      BuildReference& reference = array_[segment.first + index];
      std::uint32_t space = segment.space();
      while (!limits_.fit(segment.count() + space, segment.levels)) space /= 2;
      if (space == 0) return;
      opener_.open(reference, space + 1, scratch.children);
      if (scratch.children.empty()) continue;
      reference = scratch.children.front();
      std::copy(scratch.children.begin() + 1, scratch.children.end(), array_.begin() + segment.last);
      segment.last += static_cast<std::uint32_t>(scratch.children.size() - 1);
    }
  }

  /// Puts those left of the cheapest split first; returns how many. By the object median where there is no split, or
  /// where the levels left would not suffice for it.
  std::uint32_t partition(const Segment& segment) {
    const std::span<BuildReference> all = references(segment.first, segment.last);
    if (all.size() == 2) return 1;
    WideBox centroids;
    for (const BuildReference& reference : all) centroids.enclose(reference.bounds.centroid());
    const int bin_count = std::min(options_.bins, 2 * static_cast<int>(std::min<std::size_t>(all.size(), kMaxBins)));
    const BinMapping mapping(centroids, bin_count);
    SahBins bins(bin_count);
    for (const BuildReference& reference : all)
      bins.add(mapping.bin_of(reference.bounds.centroid()), reference.bounds, reference.primitives);
    const Split split = bins.best();
    if (split.exists()) {
      const auto position = static_cast<std::int32_t>(split.position);
      const auto middle = std::partition(all.begin(), all.end(), [&](const BuildReference& reference) {
        return mapping.bin_of(reference.bounds.centroid())[split.axis] < position;
      });
      const auto left = static_cast<std::uint32_t>(middle - all.begin());
      if (limits_.fit(left, all.size() - left, segment.levels)) return left;
    }
    const int axis = longest_axis(centroids);
    const auto key = [axis](const BuildReference& reference) {
      return static_cast<float>(reference.bounds.centroid()[axis]);
    };
    const auto half = static_cast<std::uint32_t>(all.size() / 2);
    const Rank median =
        object_median(static_cast<std::uint32_t>(all.size()), [&](std::uint32_t i) { return key(all[i]); });
    const std::vector<BuildReference> from(all.begin(), all.end());
    std::array<std::uint32_t, 2> next{0, half};
    for (std::uint32_t i = 0; i < from.size(); ++i) all[next[Rank{key(from[i]), i} < median ? 0 : 1]++] = from[i];
    return half;
  }

  /// Divides the space behind the right half in proportion to the references that are worth opening on either side,
  /// and moves the right half so that its left part lies behind the left half.
  void share_space(std::array<Segment, 2>& halves) {
    Segment& left = halves[0];
    Segment& right = halves[1];
    const auto weigh = [this](Segment& s) {
      s.bounds = bounds(s.first, s.last);
      return options_.rule.candidates(references(s.first, s.last), s.bounds, opener_);
    };
    std::uint64_t left_weight = weigh(left);
    std::uint64_t right_weight = weigh(right);
    if (left_weight + right_weight == 0) {
      left_weight = left.count();
      right_weight = right.count();
    }
    const std::uint64_t space = right.end - right.last;
    const auto shift = static_cast<std::uint32_t>(space * left_weight / (left_weight + right_weight));
    const std::uint32_t moved = std::min(shift, right.count());
    std::copy_n(array_.begin() + right.first, moved, array_.begin() + right.last + shift - moved);
    left.end += shift;
    right.first += shift;
    right.last += shift;
  }

  RebraidOptions options_;
  Opener opener_;
  const SegmentObserver& observer_;
  BuildLimits limits_;
  std::vector<BuildReference> array_;
  NodeTree tree_;
};

Option depth_option() {
  return {"depth", "most levels of inner nodes; beyond, nodes are split at the object median", 32, 1, 64};
}
Option bins_option() { return {"bins", "bins an axis", 16, 4, kMaxBins}; }

TopLevel build_plain(const InstancedTrees& trees, const OptionValues& values) {
  RebraidOptions options;
  options.bins = static_cast<int>(values.integer("bins"));
  options.depth = static_cast<int>(values.integer("depth"));
  options.threads = static_cast<int>(values.integer("threads"));
  return build_rebraided(trees, options);
}

TopLevel build(const InstancedTrees& trees, const OptionValues& values) {
  RebraidOptions options;
  options.rule.extent = values.values.at("extent");
  options.rule.overlap = values.values.at("overlap");
  options.rule.order = static_cast<OpeningRule::Order>(values.word("order"));
  options.width = values.word("width") == 0 ? 2 : 4;
  options.open_leaves = values.word("open") == 1;
  options.bins = static_cast<int>(values.integer("bins"));
  options.depth = static_cast<int>(values.integer("depth"));
  options.threads = static_cast<int>(values.integer("threads"));
  const std::vector<Instance>& instances = trees.scene->instances;
  const auto per_instances = values.values.at("space") * static_cast<double>(instances.size());
  options.places = static_cast<std::uint64_t>(per_instances);
  const std::uint64_t triangles = values.integer("triangles");
  const bool in_place = std::all_of(instances.begin(), instances.end(),
                                    [](const Instance& instance) { return is_identity(instance.to_world); });
  if (in_place && triangles > 0)
    options.places = std::max(options.places, instanced_triangles(*trees.scene) / triangles);
  check_counts(trees.scene->name, options.places, 0);
  return build_rebraided(trees, options);
}

}  // namespace

TopLevel build_rebraided(const InstancedTrees& trees, const RebraidOptions& options, const SegmentObserver& observer) {
  const Rebraid rebraid(trees, options, observer);
  return emit_references(rebraid.tree(), rebraid.array(), trees.scene->name);
}

TopLevelKind plain_top_level() {
  return {"plain",
          "binned SAH over whole instances, weighed with their primitives",
          {bins_option(), depth_option(), threads_option()},
          build_plain};
}

TopLevelKind rebraid_top_level() {
  return {
      "rebraid",
      "binned SAH over subtrees: wide ones are opened while instances overlap (Benthin et al. 2017)",
      {{"extent", "opens what is wider than this share of its segment's longest axis", 0.1, 0, 1, false},
       {"overlap", "four references or fewer that share no more than this share of the area are not opened", 0.1, 0, 10,
        false},
       word_option("order", "which are opened first (extent: as they come; overlap: only those that meet another)",
                   {"extent", "overlap", "cost"}),
       word_option("width", "children that opening a node yields", {"2", "4"}),
       word_option("open", "what can be opened", {"inner", "leaves"}),
       {"space", "places for references, for each instance; 4 in the paper, which takes twice the time", 2, 1, 1024,
        false},
       {"triangles",
        "if no instance is transformed: or one place for so many triangles, if that is more (1000 in the paper); 0: no",
        0, 0, 1e9},
       bins_option(),
       depth_option(),
       threads_option()},
      build};
}

}  // namespace cbvh::golden
