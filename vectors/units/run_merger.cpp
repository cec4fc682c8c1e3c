// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/run_merger.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_run_merger() { return describe_unit<RunMerger>(); }

}  // namespace cbvh::vectors
