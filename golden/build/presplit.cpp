// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/presplit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "golden/build/overlap_penalty.h"
#include "golden/build/piece.h"
#include "golden/build/piece_build.h"
#include "golden/build/sweep.h"
#include "golden/build/wide_box.h"
#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

/// Divides pieces as long as they are too large, those of the largest measure first, until there are `most`. Of equals
/// the one that came first. `Shard` has a measure and a piece; halves_of(shard) gives its parts.
template <class Shard, class HalvesOf>
std::vector<Piece> divide_largest(std::vector<Shard> shards, double too_large, std::uint64_t most,
                                  const HalvesOf& halves_of) {
  const auto later = [&](std::size_t a, std::size_t b) {
    return shards[a].measure < shards[b].measure || (shards[a].measure == shards[b].measure && a > b);
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> waiting(later);
  const auto wait = [&](std::size_t i) {
    if (shards[i].measure > too_large) waiting.push(i);
  };
  for (std::size_t i = 0; i < shards.size(); ++i) wait(i);
  while (!waiting.empty() && shards.size() < most) {
    const std::size_t i = waiting.top();
    waiting.pop();
    std::vector<Shard> halves = halves_of(shards[i]);
    if (halves.empty()) continue;
    for (std::size_t k = 1; k < halves.size(); ++k) {
      shards.push_back(halves[k]);
      wait(shards.size() - 1);
    }
    shards[i] = halves[0];
    wait(i);
  }
  std::vector<Piece> pieces;
  for (const Shard& shard : shards) pieces.push_back(shard.piece);
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.id < b.id; });
  return pieces;
}

/// The sweep's tree over pieces. A leaf that holds several of one triangle names it once.
FloatTree sweep_pieces(const std::vector<Piece>& pieces, const Mesh& mesh, const BuildLimits& limits) {
  check_counts(mesh.name, pieces.size(), 0);
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const Piece& piece : pieces) boxes.push_back(piece.box);
  NodeTree tree = sweep_tree(boxes, limits);
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

std::uint64_t budget(const OptionValues& options, const Mesh& mesh) {
  const std::uint64_t most = options.integer("references");
  check_references(mesh, most);
  return most;
}

// Early split clipping.

struct ClippedShard {
  double measure;  ///< half area
  Piece piece;
};

FloatTree build_early_split(const Mesh& mesh, const OptionValues& options) {
  const std::uint64_t most = budget(options, mesh);
  const std::vector<Box> boxes = triangle_boxes(mesh);
  std::vector<ClippedShard> shards;
  Box scene = boxes.front();
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    shards.push_back({half_area(boxes[id]), {boxes[id], id}});
    scene = unite(scene, boxes[id]);
  }
  const auto halves_of = [&](const ClippedShard& shard) {
    std::vector<ClippedShard> halves;
    const Box& box = shard.piece.box;
    const int axis = longest_axis(widened(box));
    const float middle = box.lower[axis] * 0.5F + box.upper[axis] * 0.5F;
    if (!(box.lower[axis] < middle && middle < box.upper[axis])) return halves;
    for (const Box& half : {below(box, axis, middle), above(box, axis, middle)}) {
      if (const auto part = clipped_box(corners_of(mesh, shard.piece.id), half))
        halves.push_back({half_area(*part), {*part, shard.piece.id}});
    }
    return halves;
  };
  const std::vector<Piece> pieces =
      divide_largest(shards, options.values.at("area") * half_area(scene), most, halves_of);
  return sweep_pieces(pieces, mesh, build_limits(options, pieces.size(), mesh.name));
}

// The edge volume heuristic.

using Vertex = std::array<double, 3>;

struct DividedShard {
  double measure;  ///< volume of the box around the edge with most
  Piece piece;
  std::array<Vertex, 3> corners;
  std::size_t edge;  ///< from this corner to the next
  int divisions;
};

/// Middles of edges are within 2^-53 a division of the exact ones, relative to the triangle's largest coordinate.
constexpr int kMostDivisions = 64;

double edge_volume(const Vertex& a, const Vertex& b) {
  return std::abs(a[0] - b[0]) * std::abs(a[1] - b[1]) * std::abs(a[2] - b[2]);
}

DividedShard shard_of(std::uint32_t id, const std::array<Vertex, 3>& corners, const Box& whole, int divisions) {
  DividedShard shard{-1, {whole, id}, corners, 0, divisions};
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const double volume = edge_volume(corners[edge], corners[(edge + 1) % 3]);
    if (volume > shard.measure) {
      shard.measure = volume;
      shard.edge = edge;
    }
  }
  for (int axis = 0; divisions > 0 && axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto [least, greatest] = std::minmax({corners[0][a], corners[1][a], corners[2][a]});
    // 2^-46 is more than all divisions are off, as in clip.cpp.
    const double margin =
        0x1p-46 * static_cast<double>(std::max(std::abs(whole.lower[axis]), std::abs(whole.upper[axis])));
    shard.piece.box.lower[axis] =
        std::max(whole.lower[axis], rounded_down(std::max(least - margin, -0x1.fffffep127)) + 0.0F);
    shard.piece.box.upper[axis] =
        std::min(whole.upper[axis], rounded_up(std::min(greatest + margin, 0x1.fffffep127)) + 0.0F);
  }
  return shard;
}

FloatTree build_edge_volume(const Mesh& mesh, const OptionValues& options) {
  const std::uint64_t most = budget(options, mesh);
  const std::vector<Box> boxes = triangle_boxes(mesh);
  std::vector<DividedShard> shards;
  Box scene = boxes.front();
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    std::array<Vertex, 3> corners{};
    const Corners exact = corners_of(mesh, id);
    for (std::size_t corner = 0; corner < 3; ++corner)
      corners[corner] = {exact[corner].x, exact[corner].y, exact[corner].z};
    shards.push_back(shard_of(id, corners, boxes[id], 0));
    scene = unite(scene, boxes[id]);
  }
  const auto halves_of = [&](const DividedShard& shard) {
    std::vector<DividedShard> halves;
    if (shard.divisions == kMostDivisions) return halves;
    const std::size_t from = shard.edge;
    const std::size_t to = (from + 1) % 3;
    Vertex middle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] = 0.5 * shard.corners[from][axis] + 0.5 * shard.corners[to][axis];
    for (const std::size_t replaced : {to, from}) {
      std::array<Vertex, 3> corners = shard.corners;
      corners[replaced] = middle;
      halves.push_back(shard_of(shard.piece.id, corners, boxes[shard.piece.id], shard.divisions + 1));
    }
    return halves;
  };
  const double threshold = std::ldexp(volume(scene), -static_cast<int>(options.integer("t")));
  const std::vector<Piece> pieces = divide_largest(shards, threshold, most, halves_of);
  return sweep_pieces(pieces, mesh, build_limits(options, pieces.size(), mesh.name));
}

}  // namespace

BuilderKind early_split_builder() {
  std::vector<Option> options = limit_options();
  options.push_back({"area", "largest area of a triangle's box, over the scene's", 0.001, 0, 1, false});
  options.push_back(references_option());
  return {"early-split", "ESC-BVH: triangles clipped to small boxes, then the sweep (Popov et al., section 5.1)",
          options, build_early_split};
}

BuilderKind edge_volume_builder() {
  std::vector<Option> options = limit_options();
  options.push_back({"t", "largest volume around an edge: the scene's over 2^t", 14, 0, 64});
  options.push_back(references_option());
  return {"edge-volume", "EVH-BVH: triangles divided at long edges, then the sweep (Popov et al., section 5.1)",
          options, build_edge_volume};
}

}  // namespace cbvh::golden
