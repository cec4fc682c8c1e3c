// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/generic.h"

#include <utility>

#include "golden/build/centroid_sweep.h"
#include "golden/build/middle_split.h"
#include "golden/build/partition_search.h"
#include "golden/build/piece_build.h"

namespace cbvh::golden {
namespace {

class GenericBuild : public PieceBuild {
 public:
  GenericBuild(const Mesh& of, const BuildLimits& within, std::uint64_t references, const SearchRules& by,
               bool weigh_subtrees)
      : PieceBuild(of, within, references), rules(by), recursion(weigh_subtrees) {}

 private:
  bool divide(Part& part, int levels, std::array<Part, 2>& halves) override {
    part.cell = box_of(part.pieces);
    const double area = half_area(part.cell);
    const std::uint64_t count = part.pieces.size();
    if (limits.prefer_leaf(count, levels, area, 0)) return false;
    std::vector<Partition> found = cheapest_partitions(part.pieces, part.cell, mesh, rules);
    std::erase_if(found, [&](const Partition& partition) {
      if (partition.kind == Partition::Kind::objects) return false;
      return std::uint64_t{partition.left()} + partition.right() > part.allowance ||
             !limits.fit(partition.left(), partition.right(), levels) ||
             partition.cost > area * static_cast<double>(count);
    });
    if (found.empty()) {
      if (count <= limits.leaf) return false;
      found.resize(1);
      found.front().objects = best_centroid(part.pieces);
    }
    if (recursion) return divide_by_subtrees(part, found, levels, area, halves);
    if (limits.prefer_leaf(count, levels, area, found.front().cost)) return false;
    apply(part, found.front(), levels, area, halves);
    return true;
  }

  /// The partition whose halves, split in the middle, cost least, the first of equals.
  bool divide_by_subtrees(const Part& part, const std::vector<Partition>& found, int levels, double area,
                          std::array<Part, 2>& halves) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Partition& partition : found) {
      std::array<Part, 2> tried;
      apply(part, partition, levels, area, tried);
      double cost = 0;
      for (const Part& half : tried) {
        std::vector<Piece> pieces = half.pieces;
        if (!pieces.empty()) cost += middle_split_cost(pieces, limits);
      }
      cost *= partition.penalty;
      if (cost < least) {
        least = cost;
        halves = std::move(tried);
      }
    }
    const auto count = static_cast<double>(part.pieces.size());
    return part.pieces.size() > limits.leaf || limits.traversal * area + least < limits.intersection * count * area;
  }

  void apply(const Part& part, const Partition& partition, int levels, double area, std::array<Part, 2>& halves) const {
    switch (partition.kind) {
      case Partition::Kind::objects:
        return divide_objects(part, partition.objects, levels, area, halves);
      case Partition::Kind::plane:
        return divide_space(part, partition.plane, halves);
      case Partition::Kind::boxes:
        return divide_boxes(part, partition.boxes, halves);
    }
  }

  void divide_boxes(const Part& part, const ChildBoxes& children, std::array<Part, 2>& halves) const {
    const SideRule rule(children.box, rules.may_split);
    halves = {Part{{}, children.box[0], 0}, Part{{}, children.box[1], 0}};
    for (const Piece& piece : part.pieces) {
      const Side side = rule.side_of(piece, mesh);
      if (side == Side::both) {
        share(piece, children.box, halves);
      } else {
        halves[side == Side::first ? 0 : 1].pieces.push_back(piece);
      }
    }
  }

  const SearchRules rules;
  const bool recursion;
};

Option resolution_option() {
  return {"resolution", "K_R: a node's grid has the square root of K_R times its triangles cells", 1, 0, 4096, false};
}

FloatTree build_geometric(const Mesh& mesh, const OptionValues& options) {
  SearchRules rules;
  rules.centroids = options.integer("centroids") == 1;
  rules.grid = true;
  rules.may_split = false;
  rules.resolution = options.values.at("resolution");
  const BuildLimits limits = build_limits(options, mesh.triangles.size(), mesh.name);
  return GenericBuild(mesh, limits, kMaxCount, rules, false).run();
}

struct Oracles {
  const char* name;
  bool centroids;
  bool planes;
  bool grid;
};
constexpr Oracles kOracles[] = {{"all", true, true, true},          {"centroid", true, false, false},
                                {"kd", false, true, false},         {"grid", false, false, true},
                                {"centroid+kd", true, true, false}, {"centroid+grid", true, false, true},
                                {"kd+grid", false, true, true}};

FloatTree build_generic(const Mesh& mesh, const OptionValues& options) {
  const Oracles& oracles = kOracles[options.word("oracle")];
  SearchRules rules;
  rules.centroids = oracles.centroids;
  rules.planes = oracles.planes;
  rules.grid = oracles.grid;
  rules.may_split = options.integer("split") == 1;
  rules.overlap = options.values.at("overlap");
  rules.resolution = options.values.at("resolution");
  const std::uint64_t recursion = options.integer("recursion");
  if (recursion > 0) rules.most = recursion;
  const BuildLimits limits = build_limits(options, mesh.triangles.size(), mesh.name);
  return GenericBuild(mesh, limits, options.integer("references"), rules, recursion > 0).run();
}

}  // namespace

BuilderKind geometric_builder() {
  std::vector<Option> options = limit_options();
  options.push_back(resolution_option());
  options.push_back({"centroids", "1: also the centroid sweep's splits, as the paper's", 1, 0, 1});
  return {"geometric", "GP-BVH: boxes on a grid that hold triangles whole (Popov et al., section 3)", options,
          build_geometric};
}

BuilderKind generic_builder() {
  std::vector<Option> options = limit_options();
  std::vector<std::string> words;
  for (const Oracles& oracles : kOracles) words.emplace_back(oracles.name);
  options.push_back(word_option("oracle", "what is searched", words));
  options.push_back({"overlap", "C_O, the penalty on children that overlap", 0, 0, 1e17, false});
  options.push_back(resolution_option());
  options.push_back({"split", "1: triangles may be split between boxes of the grid", 1, 0, 1});
  options.push_back(
      {"recursion", "weigh so many of the cheapest partitions by subtrees split in the middle; 0: none", 0, 0, 1024});
  options.push_back(references_option());
  return {"generic", "G-BVH: the generic partitioner with its oracles (Popov et al., section 4)", options,
          build_generic};
}

}  // namespace cbvh::golden
