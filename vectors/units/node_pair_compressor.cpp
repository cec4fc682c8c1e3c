// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/node_pair_compressor.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_node_pair_compressor() { return describe_unit_of_bits<NodePairCompressor>(); }

}  // namespace cbvh::vectors
