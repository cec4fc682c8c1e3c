// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/build_limits.h"

#include "golden/input_error.h"

namespace cbvh::golden {

std::vector<Option> limit_options() {
  return {{"leaf", "most triangles a leaf", 4, 1, 1024},
          {"depth", "most levels of inner nodes; beyond, nodes are split at the object median", 32, 1, 64},
          {"traversal", "C_T of the SAH, the cost of an inner node", 1, 0, 1e6, false},
          {"intersection", "C_I of the SAH, the cost of a triangle", 1, 0, 1e6, false}};
}

Option threads_option() { return {"threads", "threads that build; the result is the same", 1, 1, 256}; }

BuildLimits build_limits(const OptionValues& values, std::uint64_t primitives, const std::string& place) {
  BuildLimits limits;
  limits.leaf = values.integer("leaf");
  limits.depth = static_cast<int>(values.integer("depth"));
  limits.traversal = values.values.at("traversal");
  limits.intersection = values.values.at("intersection");
  if (values.values.contains("threads")) limits.threads = static_cast<int>(values.integer("threads"));
  if (!limits.fit(primitives, limits.depth)) {
    throw InputError(
        place,
        fmt::format(
            "{} triangles do not fit {} levels of inner nodes with leaves of {}, want more depth or larger leaves",
            primitives, limits.depth, limits.leaf));
  }
  return limits;
}

}  // namespace cbvh::golden
