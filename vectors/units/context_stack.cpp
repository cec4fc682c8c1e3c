// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/context_stack.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_context_stack() {
  UnitDescription unit = describe_unit_of_bits<ContextStack>();
  unit.bits = {6};
  return unit;
}

}  // namespace cbvh::vectors
