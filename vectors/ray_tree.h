// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/tree/compressed_tree.h"
#include "vectors/convert.h"
#include "vectors/faces/axis.h"
#include "vectors/faces/traversal.h"
#include "vectors/ray_convert.h"

namespace cbvh::vectors {

/// The root's box as rays meet it: its cells on its own grid, whose edges are what its children are relative to. The
/// tree's e_min is at or above the exactness limit.
struct RootCells {
  std::array<PlainDistances, 3> edges;  ///< lower and upper
  std::array<PlainGridAxis, 3> grid;
};
inline RootCells root_cells(const golden::CompressedTree& tree) {
  RootCells root{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<int>(axis);
    const int scale = tree.root[axis].scale;
    const auto cells = golden::encode<Index>(tree.scene.lower[a], tree.scene.upper[a], scale);
    root.edges[axis] = {decoded_edge(cells.lower, scale), decoded_edge(cells.upper, scale)};
    root.grid[axis] = {scale, static_cast<int>(golden::modulo(cells.lower, tree.rules.bits)),
                       static_cast<int>(cells.upper - cells.lower)};
  }
  return root;
}

/// The tree as the golden traverses it. It refers to `tree`.
inline PlainRayTree plain_ray_tree(const golden::CompressedTree& tree) {
  const RootCells root = root_cells(tree);
  return {[&tree](std::uint32_t index) { return tree.pairs.at(index); },
          [&tree](std::uint32_t index) { return tree.primitive_ids.at(index); },
          tree.pairs.empty(),
          tree.pairs.empty() ? 0 : static_cast<std::uint32_t>(tree.pairs.size() - 1),
          root.edges,
          root.grid,
          scene_registers(tree.rules, tree.code)};
}
inline PlainRay plain_ray(const rtl::RayJob& job) {
  PlainRay ray{{}, {}, job.t_min.value(), job.t_max.value()};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = job.origin[axis].value();
    ray.direction[axis] = job.direction[axis].value();
  }
  return ray;
}

/// The traversal unit's wires for a tree whose arrays begin at these lines.
template <int N>
rtl::RayTree<N> ray_tree(const golden::CompressedTree& tree, std::uint64_t pairs_line, std::uint64_t ids_line) {
  const RootCells root = root_cells(tree);
  rtl::RayTree<N> wires;
  wires.pairs = rtl::LineAddress(pairs_line);
  wires.ids = rtl::LineAddress(ids_line);
  wires.leaf = rtl::UInt<1>(tree.pairs.empty());
  wires.root = rtl::Pointer(tree.pairs.empty() ? 0 : tree.pairs.size() - 1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    wires.box.lower[axis] = rtl::Float32::of(root.edges[axis].near);
    wires.box.upper[axis] = rtl::Float32::of(root.edges[axis].far);
  }
  wires.grid = to_wires<N>(PlainReachedNode{root.grid, {}}).grid;
  wires.registers = scene_registers(tree.rules, tree.code);
  return wires;
}

}  // namespace cbvh::vectors
