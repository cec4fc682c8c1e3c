// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/pair_intersector.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_pair_intersector() { return describe_unit_of_bits<PairIntersector>(); }

}  // namespace cbvh::vectors
