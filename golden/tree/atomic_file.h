// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cbvh::golden {

/// Writes the whole file or nothing: a temporary file beside it, fsync, rename. On failure throws InputError with the
/// reason, removes the temporary file and leaves what was there before.
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace cbvh::golden
