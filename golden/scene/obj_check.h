// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cbvh::golden {

struct ObjCounts {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;  ///< once polygons are fans
};

/// Throws InputError, with the line, unless every statement is one of OBJ, every vertex has finite coordinates and
/// every face names existing vertices. tinyobjloader takes 0 for a number it cannot read ("nan" too), does not check
/// indices and gives no line.
ObjCounts check_obj(std::string_view text, const std::string& file);

}  // namespace cbvh::golden
