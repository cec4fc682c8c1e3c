// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "testbench/backend/responses.h"
#include "testbench/report/report.h"
#include "vectors/vector_set.h"

namespace cbvh::testbench {

struct CompareOptions {
  bool stalled = false;  ///< a response may come later than stated, but never earlier; else in its cycle exactly
  /// The command line that reruns the case of this id alone.
  std::function<std::string(std::uint64_t id)> rerun = [](std::uint64_t) { return std::string(); };
};

/// Compares what a backend gave with the responses stored in a set, bit for bit, and adds every check to the report:
/// one a response field, one a stated latency, one a surplus response. A missing response fails all of its checks.
void compare(const vectors::VectorSet& wanted, const Responses& found, const CompareOptions& options,
             SetReport& report);

}  // namespace cbvh::testbench
