// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/regression/plan.h"
#include "testbench/report/report.h"

namespace cbvh::testbench {

/// Runs a suite, or the shard of it that was asked for. The totals do not depend on shards or threads.
Report regress(const RegressionOptions& options);

/// Runs planned sets: pieces on threads, each with counts of its own, added up at the end in the order of the plan.
void run_plan(const std::vector<PlannedSet>& plan, const RegressionOptions& options, Report& report);

}  // namespace cbvh::testbench
