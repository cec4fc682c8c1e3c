// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/payloads.h"

/// What travels between the modules that send rays through a compressed tree.
namespace cbvh::rtl {

/// One axis of a ray, as the box tests need it.
struct RayAxis {
  Float32 inverse;    ///< the largest binary32 not above 1 / |d|; 1 where the ray is parallel
  UInt<1> backwards;  ///< d < 0: the ray enters boxes at their upper planes
  UInt<1> parallel;   ///< d = 0, of either sign: distances are those of the planes from the origin, not t
  static constexpr auto fields() {
    return field_list("inverse", &RayAxis::inverse, "backwards", &RayAxis::backwards, "parallel", &RayAxis::parallel);
  }
  bool operator==(const RayAxis&) const = default;
};

/// Where a ray meets the two planes of a box on one axis: not after the exact place of the one it enters through, and
/// not before that of the one it leaves through.
struct PlaneDistances {
  Float32 near;
  Float32 far;
  static constexpr auto fields() { return field_list("near", &PlaneDistances::near, "far", &PlaneDistances::far); }
  bool operator==(const PlaneDistances&) const = default;
};

/// A ray and the box of the tree's root.
struct RaySetupJob {
  std::array<Float32, 3> origin;
  std::array<Float32, 3> direction;
  FloatBox root;  ///< decoded; +-infinity stands for +-2^128
  static constexpr auto fields() {
    return field_list("origin", &RaySetupJob::origin, "direction", &RaySetupJob::direction, "root", &RaySetupJob::root);
  }
  bool operator==(const RaySetupJob&) const = default;
};

struct RaySetupResult {
  std::array<RayAxis, 3> ray;
  std::array<PlaneDistances, 3> planes;  ///< of the root's box
  StatusBits status;                     ///< not_finite, inverted or ok
  static constexpr auto fields() {
    return field_list("ray", &RaySetupResult::ray, "planes", &RaySetupResult::planes, "status",
                      &RaySetupResult::status);
  }
  bool operator==(const RaySetupResult&) const = default;
};

/// One axis of a node's own grid, as far as its children's codes need it: the lower index modulo 2^N, and how many
/// cells the node spans.
template <int N>
struct GridAxis {
  Scale scale;
  UInt<N> lower;
  UInt<N + 1> cells;
  static constexpr auto fields() {
    return field_list("scale", &GridAxis::scale, "lower", &GridAxis::lower, "cells", &GridAxis::cells);
  }
  bool operator==(const GridAxis&) const = default;
};

/// A node that a ray reached.
template <int N>
struct ReachedNode {
  std::array<GridAxis<N>, 3> grid;
  std::array<PlaneDistances, 3> planes;
  static constexpr auto fields() { return field_list("grid", &ReachedNode::grid, "planes", &ReachedNode::planes); }
  bool operator==(const ReachedNode&) const = default;
};

/// A pair of stored children, their parent, and a ray.
template <int N>
struct PairTestJob {
  NodePair<N> pair;
  ReachedNode<N> node;  ///< the parent
  std::array<RayAxis, 3> ray;
  Float32 t_min;
  Float32 t_max;
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pair", &PairTestJob::pair, "node", &PairTestJob::node, "ray", &PairTestJob::ray, "t_min",
                      &PairTestJob::t_min, "t_max", &PairTestJob::t_max, "registers", &PairTestJob::registers);
  }
  bool operator==(const PairTestJob&) const = default;
};

/// One child of a tested pair.
template <int N>
struct TestedChild {
  UInt<1> hit;    ///< entry <= exit, and between the planes of every axis the ray is parallel to
  Float32 entry;  ///< t, not after the exact one
  Float32 exit;   ///< not before the exact one
  ReachedNode<N> node;
  UInt<1> leaf;
  Pointer pointer;
  static constexpr auto fields() {
    return field_list("hit", &TestedChild::hit, "entry", &TestedChild::entry, "exit", &TestedChild::exit, "node",
                      &TestedChild::node, "leaf", &TestedChild::leaf, "pointer", &TestedChild::pointer);
  }
  bool operator==(const TestedChild&) const = default;
};

template <int N>
struct PairTestResult {
  std::array<TestedChild<N>, 2> child;
  UInt<1> second_first;  ///< the ray enters child 1 before child 0
  StatusBits status;     ///< not_finite, inverted, scale_below_minimum, too_wide or ok
  static constexpr auto fields() {
    return field_list("child", &PairTestResult::child, "second_first", &PairTestResult::second_first, "status",
                      &PairTestResult::status);
  }
  bool operator==(const PairTestResult&) const = default;
};

}  // namespace cbvh::rtl
