// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/ray.h"

#include "golden/input_error.h"

namespace cbvh::golden {

void check_ray(const Ray& ray, const std::string& place) {
  bool moves = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(ray.origin[axis]))
      throw InputError(place,
                       fmt::format("origin {}: found {}, wanted a finite number", "xyz"[axis], ray.origin[axis]));
    if (!std::isfinite(ray.direction[axis])) {
      throw InputError(place,
                       fmt::format("direction {}: found {}, wanted a finite number", "xyz"[axis], ray.direction[axis]));
    }
    moves |= ray.direction[axis] != 0;
  }
  if (!moves) throw InputError(place, "direction: found 0 0 0, wanted a component that is not zero");
  const bool ordered = ray.t_min <= ray.t_max;  // false for NaN
  if (!ordered) throw InputError(place, fmt::format("t from {} to {}, wanted an interval", ray.t_min, ray.t_max));
}

PreparedRay::PreparedRay(const WideRay& ray) : ends_{ray.t_min, ray.t_max}, origin_{}, inverse_{}, parallel_{} {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    origin_[a] = ray.origin[axis];
    parallel_[a] = ray.direction[axis] == 0;
    inverse_[a] = parallel_[a] ? 0 : 1 / ray.direction[axis];
  }
}

}  // namespace cbvh::golden
