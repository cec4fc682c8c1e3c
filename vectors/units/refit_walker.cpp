// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/refit_walker.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_refit_walker() { return describe_unit<RefitWalker>(); }

}  // namespace cbvh::vectors
