// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/box_decoder.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_box_decoder() { return describe_unit_of_bits<BoxDecoder>(); }

}  // namespace cbvh::vectors
