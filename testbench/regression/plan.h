// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/backend/run_options.h"
#include "testbench/report/report.h"
#include "vectors/vector_set.h"

namespace cbvh::testbench {

/// What `cbvh regress` was asked for.
struct RegressionOptions {
  std::string suite = "smoke";
  std::vector<std::string> units;     ///< empty: all
  std::vector<std::string> scenes;    ///< empty: the suite's own
  std::vector<std::string> backends;  ///< empty: rtl
  std::vector<std::string> stalls;    ///< empty: the suite's own
  std::optional<std::uint64_t> shuffle;
  std::uint64_t seed = 1;
  Shard shard;
  unsigned threads = 0;
  std::string set;                    ///< only sets of this name
  std::optional<std::uint64_t> only;  ///< only the case of this id

  /// Whether it is less than a whole suite, so that bins may stay empty.
  bool restricted() const;
  bool wants(std::string_view unit) const;
};

/// A set of cases, and how it is to be run: the unit of reporting. Its cases are made when a piece of it runs.
struct PlannedSet {
  SetReport report;  ///< names and totals; nothing counted yet
  RunOptions run;
  std::uint64_t piece_size = 1;  ///< cases a thread takes at a time
  std::uint64_t first_id = 0;    ///< ids are consecutive; sets of one case count on, so that shards share them out
  /// Runs the cases of these ids and adds what it found to the report.
  std::function<void(const std::vector<std::uint64_t>& ids, SetReport& report)> work;
};

/// The sets of a suite. Throws InputError for an unknown suite, unit, scene, backend or stalls, naming the known ones.
std::vector<PlannedSet> make_plan(const RegressionOptions& options);

std::vector<std::string> suite_names();

/// The command line that runs this set alone, up to `--only ID`.
std::string rerun_line(const RegressionOptions& options, const PlannedSet& set);

}  // namespace cbvh::testbench
