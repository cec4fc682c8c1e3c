// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/primitive_gatherer.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_primitive_gatherer() { return describe_unit<PrimitiveGatherer>(); }

}  // namespace cbvh::vectors
