// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/ray_payloads.h"
#include "vectors/convert.h"
#include "vectors/faces/ray.h"

/// Rays and the nodes they reach as payloads of the hardware, and back. Nothing is computed here.
namespace cbvh::vectors {

inline rtl::PlaneDistances to_wires(const PlainDistances& planes) {
  return {rtl::Float32::of(planes.near), rtl::Float32::of(planes.far)};
}
inline PlainDistances from_wires(const rtl::PlaneDistances& planes) {
  return {planes.near.value(), planes.far.value()};
}
inline rtl::RayAxis to_wires(const PlainRayAxis& axis) {
  return {rtl::Float32::of(axis.inverse), rtl::UInt<1>(axis.backwards), rtl::UInt<1>(axis.parallel)};
}
inline PlainRayAxis from_wires(const rtl::RayAxis& axis) {
  return {axis.inverse.value(), bool(axis.backwards), bool(axis.parallel)};
}

template <int N>
rtl::ReachedNode<N> to_wires(const PlainReachedNode& node) {
  rtl::ReachedNode<N> wires;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PlainGridAxis& grid = node.grid[axis];
    wires.grid[axis] = {rtl::Scale(grid.scale), rtl::UInt<N>(static_cast<std::uint64_t>(grid.lower)),
                        rtl::UInt<N + 1>(static_cast<std::uint64_t>(grid.cells))};
    wires.planes[axis] = to_wires(node.planes[axis]);
  }
  return wires;
}
template <int N>
PlainReachedNode from_wires(const rtl::ReachedNode<N>& wires) {
  PlainReachedNode node{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const rtl::GridAxis<N>& grid = wires.grid[axis];
    node.grid[axis] = {static_cast<int>(grid.scale.value()), static_cast<int>(grid.lower.value()),
                       static_cast<int>(grid.cells.value())};
    node.planes[axis] = from_wires(wires.planes[axis]);
  }
  return node;
}

template <int N>
rtl::PairTestJob<N> to_wires(const PlainPairTest& test) {
  rtl::PairTestJob<N> wires;
  wires.pair = node_pair<N>(test.pair);
  wires.node = to_wires<N>(test.node);
  for (std::size_t axis = 0; axis < 3; ++axis) wires.ray[axis] = to_wires(test.ray[axis]);
  wires.t_min = rtl::Float32::of(test.t_min);
  wires.t_max = rtl::Float32::of(test.t_max);
  wires.registers = test.registers;
  return wires;
}
template <int N>
PlainPairTest from_wires(const rtl::PairTestJob<N>& wires) {
  PlainPairTest test{compressed_pair(wires.pair), from_wires(wires.node), {},
                     wires.t_min.value(),         wires.t_max.value(),    wires.registers};
  for (std::size_t axis = 0; axis < 3; ++axis) test.ray[axis] = from_wires(wires.ray[axis]);
  return test;
}

}  // namespace cbvh::vectors
