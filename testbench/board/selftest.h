// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "testbench/report/report.h"

namespace cbvh::testbench {

struct BoardSelftest {
  std::uint64_t cases = 200;  ///< of a unit without state; a tenth of one with state, at least one of each class
  std::uint64_t seed = 1;
};

/// Generated cases of every unit, N and D that the board has and this program knows, compared with the golden. Throws
/// Unavailable when there is no board, LinkError.
Report selftest_board(const BoardSelftest& options);

}  // namespace cbvh::testbench
