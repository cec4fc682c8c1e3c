// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/runtime.h"

namespace cbvh::testbench {

MeasureRuntime runtime_measurement() { return {}; }

}  // namespace cbvh::testbench
