// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "testbench/trace/picture.h"
#include "testbench/trace/png.h"

namespace cbvh::testbench {

/// What an image shows of a picture.
enum class ImageKind : std::uint8_t {
  shaded,          ///< light, brighter by its square root; blue where nothing is hit
  normals,         ///< their components as red, green and blue
  box_tests,       ///< a heat map: black none, white the most of any pixel
  triangle_tests,  ///< the same
  difference,      ///< white where trees do not see the same, black elsewhere
};
inline constexpr std::array<std::string_view, 5> kImageKinds = {"shaded", "normals", "box-tests", "triangle-tests",
                                                                "difference"};

/// The most tests of any pixel: what is white in a heat map.
std::uint32_t most_tests(const TracedPicture& picture, ImageKind kind);

Image draw(const TracedPicture& picture, ImageKind kind);

}  // namespace cbvh::testbench
