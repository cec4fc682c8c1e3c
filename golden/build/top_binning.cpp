// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/top_binning.h"

#include <algorithm>

#include "golden/build/sah_bins.h"

namespace cbvh::golden {
namespace {

/// Subtrees a thread: enough to share the work out evenly however different they are.
constexpr std::uint32_t kSubtreesPerThread = 4;
/// Smaller nodes are not worth a meeting of all threads.
constexpr std::uint32_t kSmallestShared = 4096;

struct OpenNode {
  Subtree subtree;
  WideBox centroids;
};

/// What a thread found out about its share of a node. Others read it after the next meeting.
struct Part {
  explicit Part(int bins_an_axis) : bins(bins_an_axis) {}
  SahBins bins;
  std::array<WideBox, 2> boxes;      ///< of what went left and right
  std::array<WideBox, 2> centroids;  ///< of those
};

class TopBinning {
 public:
  TopBinning(const BuildLimits& limits, int bins, SubtreeArrays& arrays)
      : limits_(limits),
        bins_(bins),
        arrays_(arrays),
        parts_(static_cast<std::size_t>(limits.threads), Part(bins)),
        largest_(limits.threads == 1
                     ? arrays.count()
                     : std::max({arrays.count() / (kSubtreesPerThread * static_cast<std::uint32_t>(limits.threads)),
                                 kSmallestShared, static_cast<std::uint32_t>(limits.leaf)})) {}

  /// What each member does. All go through the same nodes in the same order, each with its own stack of them.
  void run(const Mesh& mesh, const TeamMember& member) {
    const std::array<WideBox, 2> written = write_references(mesh, member, arrays_);
    parts_[member.index()].boxes[0] = written[0];
    parts_[member.index()].centroids[0] = written[1];
    member.wait();
    std::vector<OpenNode> open{
        {Subtree{.count = arrays_.count(), .levels = limits_.depth, .box = merged(&Part::boxes, 0)},
         merged(&Part::centroids, 0)}};
    member.wait();
    while (!open.empty()) {
      const OpenNode node = open.back();
      open.pop_back();
      if (node.subtree.count <= largest_ || !divide(node, member, open)) {
        if (member.index() == 0) subtrees.push_back(node.subtree);
      }
    }
  }

  std::vector<Subtree> subtrees;

 private:
  WideBox merged(std::array<WideBox, 2> Part::*boxes, std::size_t half) const {
    WideBox all;
    for (const Part& part : parts_) all.enclose((part.*boxes)[half]);
    return all;
  }

  /// False if bins do not split the node.
  bool divide(const OpenNode& node, const TeamMember& member, std::vector<OpenNode>& open) {
    const Subtree& subtree = node.subtree;
    const BinMapping mapping(node.centroids, bins_);
    const TeamMember::Share share = member.share(subtree.count);
    const Reference* const from = arrays_.buffer(subtree.side) + subtree.first;
    Part& mine = parts_[member.index()];
    mine.bins.clear();
    for (std::uint32_t i = share.first; i < share.last; ++i)
      mine.bins.add(mapping.bin_of(from[i].box().centroid()), from[i].box(), 1);
    member.wait();
    SahBins all(bins_);
    for (const Part& part : parts_) all.merge(part.bins);
    const Split split = all.best();
    std::uint32_t left_before = 0;
    for (unsigned other = 0; other < member.index(); ++other) left_before += parts_[other].bins.left(split);
    if (!limits_.usable(split, half_area(subtree.box), subtree.count, subtree.levels)) {
      member.wait();  // before anybody fills bins again
      return false;
    }

    Reference* const to = arrays_.buffer(!subtree.side) + subtree.first;
    std::array<std::uint32_t, 2> next{left_before, split.left + share.first - left_before};
    std::array<WideBox, 2> boxes;
    std::array<WideBox, 2> centroids;
    for (std::uint32_t i = share.first; i < share.last; ++i) {
      const Float4 centroid = from[i].box().centroid();
      const std::size_t half = mapping.bin_of(centroid)[split.axis] < static_cast<std::int32_t>(split.position) ? 0 : 1;
      to[next[half]++] = from[i];
      boxes[half].enclose(from[i].box());
      centroids[half].enclose(centroid);
    }
    mine.boxes = boxes;
    mine.centroids = centroids;
    member.wait();
    const std::array<WideBox, 2> both{merged(&Part::boxes, 0), merged(&Part::boxes, 1)};
    const auto halves = member.index() == 0 ? arrays_.split(subtree, split.left, both)
                                            : SubtreeArrays::halves(subtree, split.left, both);
    for (std::size_t half = 0; half < 2; ++half) open.push_back({halves[half], merged(&Part::centroids, half)});
    return true;
  }

  const BuildLimits& limits_;
  int bins_;
  SubtreeArrays& arrays_;
  std::vector<Part> parts_;
  std::uint32_t largest_;  ///< what a thread builds alone
};

}  // namespace

std::vector<Subtree> split_by_binning(const Mesh& mesh, const BuildLimits& limits, int bins, SubtreeArrays& arrays) {
  TopBinning top(limits, bins, arrays);
  run_team(static_cast<unsigned>(limits.threads), [&](const TeamMember& member) { top.run(mesh, member); });
  return std::move(top.subtrees);
}

}  // namespace cbvh::golden
