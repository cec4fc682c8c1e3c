// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/eval/table.h"
#include "testbench/trace/hits/compare_hits.h"

namespace cbvh::testbench {

/// A row for each set, and one for all rays.
Table hits_table(const std::string& scene, const std::vector<HitsResult>& results);

/// Every ray is two checks: Embree's hit, and the compressed tree's.
struct HitsSummary {
  std::string text;
  Json json;
  bool pass;
};
HitsSummary summary_of(const std::string& scene, const std::vector<HitsResult>& results);

}  // namespace cbvh::testbench
