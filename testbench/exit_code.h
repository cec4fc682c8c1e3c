// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cbvh::testbench {

/// What the command tells its caller. Numbers are part of the interface.
enum ExitCode : int {
  kPass = 0,
  kMismatch = 1,  ///< something was not as the golden wants it
  kBadInput = 2,  ///< a file, an argument or an option is wrong: one line on stderr says where and what
  kSkipped = 77   ///< what the run needs is not here (no board, no simulator)
};

}  // namespace cbvh::testbench
