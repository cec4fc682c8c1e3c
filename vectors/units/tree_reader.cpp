// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/tree_reader.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_tree_reader() { return describe_unit<TreeReader>(); }

}  // namespace cbvh::vectors
