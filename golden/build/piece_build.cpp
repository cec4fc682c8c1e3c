// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/piece_build.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "golden/build/centroid_sweep.h"
#include "golden/build/wide_box.h"
#include "golden/input_error.h"

namespace cbvh::golden {
PieceBuild::PieceBuild(const Mesh& of, const BuildLimits& within, std::uint64_t references)
    : mesh(of), limits(within), references_(references) {
  check_references(mesh, references);
}

FloatTree PieceBuild::run() {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  Part root{{}, {}, references_};
  for (std::uint32_t id = 0; id < boxes.size(); ++id) root.pieces.push_back({boxes[id], id});
  root.cell = box_of(root.pieces);
  tree_.nodes.emplace_back();
  build(std::move(root), 0, limits.depth);
  return emit(tree_, mesh.triangles.size(), mesh.name);
}

void PieceBuild::build(Part part, std::uint32_t node, int levels) {
  std::array<Part, 2> halves;
  do {
    if (!divide(part, levels, halves)) return make_leaf(part.pieces, node);
    const std::uint64_t left = halves[0].pieces.size();
    const std::uint64_t right = halves[1].pieces.size();
    const std::uint64_t surplus = part.allowance - left - right;
    halves[0].allowance = left + surplus * left / (left + right);
    halves[1].allowance = part.allowance - halves[0].allowance;
    if (left > 0 && right > 0) break;
    part = std::move(halves[left == 0 ? 1 : 0]);
  } while (true);
  part = {};
  const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
  tree_.nodes.resize(tree_.nodes.size() + 2);
  tree_.nodes[node] = {{}, first, 0};
  build(std::move(halves[0]), first, levels - 1);
  build(std::move(halves[1]), first + 1, levels - 1);
}

void PieceBuild::divide_objects(const Part& part, Split split, int levels, double area,
                                std::array<Part, 2>& halves) const {
  const auto count = static_cast<std::uint32_t>(part.pieces.size());
  if (!limits.usable(split, area, count, levels)) {
    WideBox centroids;
    for (const Piece& piece : part.pieces) centroids.enclose(widened(piece.box).centroid());
    split = {0, longest_axis(centroids), count / 2, count / 2};
  }
  halves = {Part{{}, part.cell, 0}, Part{{}, part.cell, 0}};
  const std::vector<Rank> order = by_centroid(part.pieces, split.axis);
  std::vector<bool> is_left(count, false);
  for (std::uint32_t i = 0; i < split.left; ++i) is_left[order[i].index] = true;
  for (std::uint32_t i = 0; i < count; ++i) halves[is_left[i] ? 0 : 1].pieces.push_back(part.pieces[i]);
}

void PieceBuild::divide_space(const Part& part, const PlaneSplit& split, std::array<Part, 2>& halves) const {
  const std::array<Box, 2> sides{below(part.cell, split.axis, split.plane), above(part.cell, split.axis, split.plane)};
  halves = {Part{{}, sides[0], 0}, Part{{}, sides[1], 0}};
  for (const Piece& piece : part.pieces) {
    const bool left = split.goes_left(piece.box);
    if (left && split.goes_right(piece.box)) {
      share(piece, sides, halves);
    } else {
      halves[left ? 0 : 1].pieces.push_back(piece);
    }
  }
}

void PieceBuild::share(const Piece& piece, const std::array<Box, 2>& boxes, std::array<Part, 2>& halves) const {
  const Corners corners = corners_of(mesh, piece.id);
  bool kept = false;
  for (std::size_t side = 0; side < 2; ++side) {
    const Box within{glm::max(piece.box.lower, boxes[side].lower), glm::min(piece.box.upper, boxes[side].upper)};
    const auto part = clipped_box(corners, within);
    if (part) halves[side].pieces.push_back({*part, piece.id});
    kept = kept || part;
  }
  if (!kept) halves[0].pieces.push_back(piece);  // rounding had kept it: nothing of it is here
}

void PieceBuild::make_leaf(const std::vector<Piece>& pieces, std::uint32_t node) {
  const auto first = tree_.references.size();
  for (const Piece& piece : pieces) tree_.references.push_back(piece.id);
  tree_.nodes[node] = {box_of(pieces), static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(pieces.size())};
}

void check_references(const Mesh& mesh, std::uint64_t references) {
  if (mesh.triangles.size() > references) {
    throw InputError(mesh.name, fmt::format("{} triangles, but at most {} references are allowed",
                                            mesh.triangles.size(), references));
  }
}

Option references_option() {
  return {"references", "most references to triangles in leaves", static_cast<double>(kMaxCount), 1,
          static_cast<double>(kMaxCount)};
}

}  // namespace cbvh::golden
