// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/png.h"

#include <new>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace cbvh::testbench {

std::string encode_png(const Image& image) {
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  const auto width = static_cast<int>(image.width);
  const auto height = static_cast<int>(image.height);
  if (stbi_write_png_to_func(append, &bytes, width, height, 3, image.rgb.data(), 3 * width) == 0)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace cbvh::testbench
