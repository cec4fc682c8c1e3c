// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cbvh::golden {

/// All bytes of the regular file at `path`; throws InputError when it is missing, not a regular file, or unreadable.
std::string read_file(const std::string& path);

/// `text` as an error shows it: in quotes, at most 40 characters, bytes that do not print as \xNN.
std::string in_quotes(std::string_view text);

/// `text` cut to 400 characters and without control characters, for messages of libraries.
std::string one_line(std::string_view text);

}  // namespace cbvh::golden
