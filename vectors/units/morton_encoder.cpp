// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/morton_encoder.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_morton_encoder() { return describe_unit<MortonEncoder>(); }

}  // namespace cbvh::vectors
