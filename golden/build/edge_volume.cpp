// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/edge_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "golden/build/overlap_penalty.h"
#include "golden/build/piece_build.h"
#include "golden/build/presplit.h"

namespace cbvh::golden {
namespace {

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
  const std::uint64_t most = options.integer("references");
  check_references(mesh, most);
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
  return sweep_pieces(pieces, mesh, options);
}

}  // namespace

BuilderKind edge_volume_builder() {
  std::vector<Option> options = limit_options();
  options.push_back({"t", "largest volume around an edge: the scene's over 2^t", 14, 0, 64});
  options.push_back(references_option());
  return {"edge-volume", "EVH-BVH: triangles divided at long edges, then the sweep (Popov et al., section 5.1)",
          options, build_edge_volume};
}

}  // namespace cbvh::golden
