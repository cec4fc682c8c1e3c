// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "golden/build/count_tree.h"
#include "golden/build/overlap_penalty.h"
#include "golden/build/plane_sweep.h"
#include "golden/build/split.h"

namespace cbvh::golden {

/// What the generic partitioner searches (paper 001, section 4).
struct SearchRules {
  bool centroids = true;  ///< CentroidGen: what the sweep considers, pieces going where their centroids are
  bool planes = false;    ///< KDNodeGen: what a k-d tree considers
  bool grid = false;      ///< GridGen
  bool may_split = true;  ///< pieces across both boxes of the grid, counted twice; planes always split
  double overlap = 0;     ///< C_O
  double resolution = 1;  ///< K_R: the grid has sqrt(K_R pieces) cells
  std::size_t most = 1;   ///< partitions to find
};

/// One way to divide a node.
struct Partition {
  enum class Kind : std::uint8_t { objects, plane, boxes };
  Kind kind = Kind::objects;
  double cost = std::numeric_limits<double>::infinity();  ///< half area times count, of both, penalized
  double penalty = 1;
  Split objects;
  PlaneSplit plane;
  ChildBoxes boxes;

  /// Of a plane or boxes: pieces on both sides.
  std::uint32_t left() const { return kind == Kind::plane ? plane.left : boxes.count[0]; }
  std::uint32_t right() const { return kind == Kind::plane ? plane.right : boxes.count[1]; }
};

/// The cheapest partitions (Algorithm 1), of equals those that come first: by centroids, by planes, on the grid, each
/// in its oracle's order.
std::vector<Partition> cheapest_partitions(std::span<const Piece> pieces, const Box& node, const Mesh& mesh,
                                           const SearchRules& rules);

}  // namespace cbvh::golden
