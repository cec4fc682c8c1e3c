// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/stream_compressor.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_stream_compressor() { return describe_unit_of_bits<StreamCompressor>(); }

}  // namespace cbvh::vectors
