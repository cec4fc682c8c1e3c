// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "testbench/backend/backend.h"
#include "testbench/report/report.h"

namespace cbvh::testbench {

/// Runs the cases of a set on a backend and compares. Of the first case that fails a minimal one is sought and attached
/// to its mismatch. A stalled response may be late, never early.
void check_set(const vectors::VectorSet& set, const Backend& backend, const RunOptions& options,
               const std::function<std::string(std::uint64_t id)>& rerun, SetReport& report);

/// All generated classes of a unit, none hit yet.
Bins empty_classes(const vectors::UnitDescription& unit);

}  // namespace cbvh::testbench
