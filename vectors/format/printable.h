// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace cbvh::vectors {

/// Foreign text for a message: at most 40 characters, bytes that do not print as \xNN.
inline std::string printable_short(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string shown;
  for (const char c : text.substr(0, std::min(text.size(), kMost))) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) {
      shown += c;
    } else if (c == '\n') {
      shown += "\\n";
    } else {
      shown += fmt::format("\\x{:02X}", byte);
    }
  }
  return text.size() > kMost ? shown + "..." : shown;
}

/// The same in quotes.
inline std::string printable(std::string_view text) { return "'" + printable_short(text) + "'"; }

}  // namespace cbvh::vectors
