// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/trace/ray.h"

namespace cbvh::golden {

/// Ray number `index` of those that start anywhere in the box and go anywhere (paper 001, section 3.4: random rays).
Ray ray_from_within(const Box& box, std::uint64_t index);

/// Ray number `index` of those that cross the box on lines of which none is likelier than another, from before it to
/// behind it: the rays of the surface area cost model (paper 001, section 2.2), which visit a box with the probability
/// that its surface over the outer box's says. The box has an extent on at least two axes.
Ray ray_across(const Box& box, std::uint64_t index);

}  // namespace cbvh::golden
