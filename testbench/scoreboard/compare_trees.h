// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "golden/tree/compressed_tree.h"
#include "testbench/report/report.h"

namespace cbvh::testbench {

/// What a mismatch of a whole tree is to say.
struct TreeCase {
  std::uint64_t id;
  std::string case_class;
  std::string rerun;
};

/// Compares two compressed trees bit for bit: a check for each code, leaf flag and pointer of each pair (the response
/// number is the pair's), and for each axis of the root's context.
void compare_trees(const golden::CompressedTree& wanted, const golden::CompressedTree& found, const TreeCase& tree_case,
                   SetReport& report);

/// One check of a number that belongs to the tree.
void compare_number(const std::string& field, long long wanted, long long found, const TreeCase& tree_case,
                    SetReport& report, std::uint64_t response = 0);

}  // namespace cbvh::testbench
