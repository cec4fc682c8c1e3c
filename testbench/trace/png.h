// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cbvh::testbench {

/// Pixels in red, green and blue, row after row from the top.
struct Image {
  unsigned width;
  unsigned height;
  std::vector<std::uint8_t> rgb;
};

/// The bytes of a PNG file, by stb.
std::string encode_png(const Image& image);

}  // namespace cbvh::testbench
