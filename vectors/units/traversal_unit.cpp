// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/traversal_unit.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_traversal_unit() { return describe_unit_of_packed_bits<TraversalUnit>(); }

}  // namespace cbvh::vectors
