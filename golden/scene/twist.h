// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// The mesh turned around the y axis through the middle of its box: not at all at its lowest point, by `turns` whole
/// turns at its highest, in proportion between. For moving scenes to refit. Every position stays finite.
Mesh twisted(Mesh mesh, float turns);

}  // namespace cbvh::golden
