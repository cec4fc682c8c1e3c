// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cbvh::golden {

/// The parts of a glTF's JSON that make its geometry, checked, for tinygltf. tinygltf recurses over extras and
/// extensions, reads images, cuts integers to 32 bits and takes a default where a field has the wrong type; nothing
/// that could go wrong so is let through. `is_binary`: the JSON is a GLB's, whose first buffer may be the BIN chunk.
std::string geometry_json(std::string_view text, const std::string& file, bool is_binary);

}  // namespace cbvh::golden
