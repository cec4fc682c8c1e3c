// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/scene/mesh.h"
#include "golden/tree/compressed_tree.h"
#include "rtl_model/memory/line_store.h"

/// What the driver puts into the simulated memory, and what it finds there.
namespace cbvh::testbench {

/// Triangles as 40-byte primitives from `first_line` on: three vertices, then the triangle's number.
void store_primitives(const golden::Mesh& mesh, std::uint64_t first_line, rtl::LineStore& store);
/// Node pairs of at most six bits a code, 16 bytes each.
void store_pairs(const golden::CompressedTree& tree, std::uint64_t first_line, rtl::LineStore& store);
void store_ids(const std::vector<std::uint32_t>& ids, std::uint64_t first_line, rtl::LineStore& store);

std::vector<golden::CompressedPair> load_pairs(std::uint64_t first_line, std::size_t count,
                                               const rtl::LineStore& store);
std::vector<std::uint32_t> load_ids(std::uint64_t first_line, std::size_t count, const rtl::LineStore& store);

/// The first difference between the 64-byte float pairs in memory and the tree's; empty if there is none.
std::string compare_float_pairs(const golden::FloatTree& wanted, std::uint64_t first_line, const rtl::LineStore& store);
/// The first difference between two compressed trees in pairs, IDs or root; empty if there is none.
std::string first_difference(const golden::CompressedTree& wanted, const golden::CompressedTree& found);

}  // namespace cbvh::testbench
