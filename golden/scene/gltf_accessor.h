// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace cbvh::golden {

/// A loaded glTF and the file to name in errors.
struct GltfSource {
  const tinygltf::Model& model;
  const std::string& file;
};

/// Elements of the accessor at `index` once it is known to hold positions (FLOAT VEC3) and to lie inside its buffers.
/// `user` says in errors who refers to the accessor, as "meshes[0].primitives[1].attributes.POSITION".
std::uint64_t count_positions(const GltfSource& source, int index, const std::string& user);

/// The same for indices (UNSIGNED_BYTE, _SHORT or _INT SCALAR).
std::uint64_t count_indices(const GltfSource& source, int index, const std::string& user);

/// Appends the elements, sparse replacements made. The accessor must have passed count_positions.
void append_positions(const GltfSource& source, int index, std::vector<glm::vec3>& positions);

/// The elements, sparse replacements made. The accessor must have passed count_indices.
std::vector<std::uint32_t> read_indices(const GltfSource& source, int index);

}  // namespace cbvh::golden
