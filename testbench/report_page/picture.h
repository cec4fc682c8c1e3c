// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "testbench/report_page/markup.h"

namespace cbvh::testbench {

/// A PNG file (ISO/IEC 15948).
struct Picture {
  std::string place;
  std::string bytes;
  std::uint32_t width = 0;  ///< pixels
  std::uint32_t height = 0;
};

/// Begins as every PNG does.
bool is_png(const std::string& bytes);

/// Checks the file's chunks, from the header to the end, with their checksums; pixels are the browser's. Throws
/// InputError with the offset.
Picture read_picture(const std::string& place, const std::string& bytes);

/// The picture with its name, its size and the command that made it, if that is known; its bytes within the page.
Markup show_picture(const Picture& picture, const std::string& command_line);

/// RFC 4648.
std::string base64(const std::string& bytes);

}  // namespace cbvh::testbench
