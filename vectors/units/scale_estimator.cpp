// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/scale_estimator.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_scale_estimator() { return describe_unit_of_bits<ScaleEstimator>(); }

}  // namespace cbvh::vectors
