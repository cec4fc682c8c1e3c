// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// Early split clipping (Ernst, Greiner 2007; ESC-BVH of paper 001, section 5.1): before the centroid sweep, triangles
/// whose boxes have too much area are clipped to halves of them, along the longest axis.
BuilderKind early_split_builder();

}  // namespace cbvh::golden
