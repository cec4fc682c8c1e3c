// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/run_sorter.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_run_sorter() { return describe_unit<RunSorter>(); }

}  // namespace cbvh::vectors
