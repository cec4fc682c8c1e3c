// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/box_builder.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_box_builder() { return describe_unit<BoxBuilder>(); }

}  // namespace cbvh::vectors
