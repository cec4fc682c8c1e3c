// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/hierarchy_emitter.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_hierarchy_emitter() { return describe_unit<HierarchyEmitter>(); }

}  // namespace cbvh::vectors
