// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/node_writer.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_node_writer() { return describe_unit_of_packed_bits<NodeWriter>(); }

}  // namespace cbvh::vectors
