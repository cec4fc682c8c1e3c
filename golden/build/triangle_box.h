// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/common.hpp>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// The box of a triangle; zeros are positive.
inline Box triangle_box(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return {glm::min(glm::min(a, b), c) + 0.0F, glm::max(glm::max(a, b), c) + 0.0F};  // -0 + 0 is 0
}

}  // namespace cbvh::golden
