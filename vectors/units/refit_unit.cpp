// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/refit_unit.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_refit_unit() { return describe_unit_of_packed_bits<RefitUnit>(); }

}  // namespace cbvh::vectors
