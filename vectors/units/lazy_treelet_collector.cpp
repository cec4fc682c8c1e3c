// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/units/treelet_collector.h"

#include "vectors/typed_vector_set.h"
#include "vectors/units/describe.h"

namespace cbvh::vectors {

UnitDescription describe_lazy_treelet_collector() { return describe_unit_of_bits<LazyTreeletCollector>(); }

}  // namespace cbvh::vectors
