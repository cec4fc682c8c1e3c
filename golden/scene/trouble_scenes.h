// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// Kinds of small scenes that break quantized builders.
enum class Trouble : std::uint8_t {
  huge,              ///< coordinates up to the largest float; extents overflow
  tiny,              ///< coordinates of 2^-126 .. 2^-96
  subnormal,         ///< multiples of 2^-149
  negative_offsets,  ///< a small object far on the negative side of an axis or more
  lattice,           ///< coordinates on multiples of a power of two: bounds lie on cell edges
  duplicates,        ///< few distinct triangles, many times
  points,            ///< triangles that are points
  equal_codes,       ///< clusters that share a Morton code, and one triangle far away
  planes,            ///< all triangles share a plane of one axis, often at an awkward height
  mixed_scales,      ///< triangle sizes over forty powers of two
  axis_aligned,      ///< right triangles in axis-parallel planes
  single_triangle,   ///< one triangle, now and then degenerate
};

inline constexpr std::array kTroubles{
    Trouble::huge,    Trouble::tiny,         Trouble::subnormal,    Trouble::negative_offsets,
    Trouble::lattice, Trouble::duplicates,   Trouble::points,       Trouble::equal_codes,
    Trouble::planes,  Trouble::mixed_scales, Trouble::axis_aligned, Trouble::single_triangle};

/// The enumerator's name, for messages.
const char* name_of(Trouble trouble);

/// A scene of 1 .. most_triangles triangles of one kind. The same arguments give the same scene everywhere; the mesh's
/// name says them.
Mesh trouble_scene(Trouble trouble, std::uint64_t seed, int most_triangles = 64);

}  // namespace cbvh::golden
