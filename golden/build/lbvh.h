// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "golden/build/builder.h"

namespace cbvh::golden {

/// The linear BVH of DESIGN 3.2: triangles in order of the Morton codes of their boxes' centres (equal codes keep their
/// input order and share a leaf), split at the highest differing bit, emitted depth first and bottom up. Throws
/// InputError as triangle_boxes does.
FloatTree build_lbvh(const Mesh& mesh);

/// build_lbvh as a kind of builder; without options.
BuilderKind lbvh_builder();

/// A primitive's box and its place on the Morton curve.
struct CodedBox {
  Box box;
  std::uint32_t code;
  std::uint32_t id;
};

/// The second half of build_lbvh: leaves and pairs of primitives that are in order of their codes, at least one.
FloatTree build_hierarchy(std::span<const CodedBox> sorted);

}  // namespace cbvh::golden
