// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace cbvh::testbench {

/// A vector file of vectors/sets/, compiled in so that the command runs from anywhere.
struct CommittedSet {
  std::string_view name;   ///< the file's
  std::string_view bytes;  ///< its content
};
std::vector<CommittedSet> committed_sets();

}  // namespace cbvh::testbench
