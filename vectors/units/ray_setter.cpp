// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/ray_setter.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_ray_setter() { return describe_unit<RaySetter>(); }

}  // namespace cbvh::vectors
