// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/backtrack_unit.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_backtrack_unit() { return describe_unit_of_bits<BacktrackUnit>(); }

}  // namespace cbvh::vectors
