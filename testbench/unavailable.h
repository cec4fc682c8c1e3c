// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace cbvh::testbench {

/// What a run needs is known, but not on this machine: no board, no simulator. The command exits 77.
class Unavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cbvh::testbench
