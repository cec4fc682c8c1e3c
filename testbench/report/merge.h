// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/report/report.h"

namespace cbvh::testbench {

/// A report and the file it came from.
struct NamedReport {
  std::string place;
  Report report;
};

/// The report of one whole run from those of its parts, in any order: shards, or runs of other sets (other units, other
/// stalls). Throws InputError when the parts are not of one command, suite and seed, when a set lacks a shard or has
/// one twice, or when its cases do not add up.
Report merge(const std::vector<NamedReport>& parts);

}  // namespace cbvh::testbench
