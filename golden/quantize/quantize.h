// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The exact arithmetic of quantized trees, DESIGN section 3, in one include. All functions are per axis unless they
// take a Box.
#pragma once

#include "golden/quantize/cells.h"  // IWYU pragma: export
#include "golden/quantize/codes.h"  // IWYU pragma: export
#include "golden/quantize/edge.h"   // IWYU pragma: export
#include "golden/quantize/exact.h"  // IWYU pragma: export
#include "golden/quantize/grid.h"   // IWYU pragma: export
#include "golden/quantize/scale.h"  // IWYU pragma: export
