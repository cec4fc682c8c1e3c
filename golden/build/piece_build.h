// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "golden/build/build_limits.h"
#include "golden/build/node_tree.h"
#include "golden/build/plane_sweep.h"

namespace cbvh::golden {

/// A node to build.
struct Part {
  std::vector<Piece> pieces;  ///< of each triangle at most one, by ID
  Box cell;
  std::uint64_t allowance;  ///< references that all leaves below may have
};

/// Builds a tree of pieces top down: triangles that a node's halves share. How a node is divided is for whoever derives
/// from it.
class PieceBuild {
 public:
  /// With at most so many references in leaves. Throws InputError as check_references.
  PieceBuild(const Mesh& of, const BuildLimits& within, std::uint64_t references);
  virtual ~PieceBuild() = default;
  PieceBuild(const PieceBuild&) = delete;
  PieceBuild& operator=(const PieceBuild&) = delete;

  FloatTree run();

 protected:
  /// Divides a part in two, without their allowances; one half may be empty, then the node is the other one. False if
  /// the part had better be a leaf.
  virtual bool divide(Part& part, int levels, std::array<Part, 2>& halves) = 0;

  /// At the split, or at the object median if that is not usable. `area` is the part's.
  void divide_objects(const Part& part, Split split, int levels, double area, std::array<Part, 2>& halves) const;

  /// Pieces across the plane are clipped to both sides.
  void divide_space(const Part& part, const PlaneSplit& split, std::array<Part, 2>& halves) const;

  /// A piece across both boxes, clipped to each.
  void share(const Piece& piece, const std::array<Box, 2>& boxes, std::array<Part, 2>& halves) const;

  const Mesh& mesh;
  const BuildLimits limits;

 private:
  void build(Part part, std::uint32_t node, int levels);
  void make_leaf(const std::vector<Piece>& pieces, std::uint32_t node);

  std::uint64_t references_;
  NodeTree tree_;
};

/// `references`, the most references in leaves.
Option references_option();

/// Throws InputError if a mesh has more triangles than that.
void check_references(const Mesh& mesh, std::uint64_t references);

}  // namespace cbvh::golden
