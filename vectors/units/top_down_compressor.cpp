// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/top_down_compressor.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_top_down_compressor() { return describe_unit_of_packed_bits<TopDownCompressor>(); }

}  // namespace cbvh::vectors
