// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// The bytes of a `.cbvh` file (docs/formats.md). Packed node pairs up to six bits a code, unpacked ones above.
std::string tree_to_bytes(const CompressedTree& tree);

/// The tree in the bytes of a `.cbvh` file. Throws InputError with `name`, byte offset and reason unless the file is
/// complete, its checksums hold and its tree is valid (golden/tree/validate.h): pointers in range and acyclic, leaves
/// disjoint, boxes within their parents'.
CompressedTree tree_from_bytes(std::string_view bytes, const std::string& name);

/// Writes a `.cbvh` file: all of it or nothing. Throws InputError.
void write_tree(const std::string& path, const CompressedTree& tree);

/// Reads a `.cbvh` file; as tree_from_bytes.
CompressedTree read_tree(const std::string& path);

}  // namespace cbvh::golden
