// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "testbench/shard.h"

/// What a run checked, and what it found: the one structure that commands print, write as JSON or JUnit, and merge.
namespace cbvh::testbench {

/// A response that was not as it must be. All texts are as vector files print them.
struct Mismatch {
  std::string unit;
  std::string set;
  std::uint64_t id = 0;    ///< of the case
  std::string case_class;  ///< the corner the case was made for
  std::uint64_t response = 0;
  std::string field;  ///< or "latency", "missing response", "surplus response", "hang"
  std::string found;
  std::string wanted;
  std::string rerun;    ///< the command line that reruns this case alone
  std::string minimal;  ///< the smallest case found that still fails, as a vector file; empty when none was sought
  bool operator==(const Mismatch&) const = default;
};

/// Mismatches kept per set; all are counted.
constexpr std::size_t kMismatchesKept = 8;

/// How often each bin was hit. A bin that nothing hits is present with 0.
using Bins = std::map<std::string, std::uint64_t>;

/// One vector set run on one backend in one mode.
struct SetReport {
  std::string unit;
  std::string set;  ///< where its cases come from and the parameters
  std::string backend;
  std::string mode;               ///< how it was run: stalls, tick order
  std::uint64_t total_cases = 0;  ///< of the set; `cases` of them are this report's share
  std::uint64_t cases = 0;
  std::uint64_t checks = 0;    ///< response fields and latencies compared
  std::uint64_t failures = 0;  ///< of the checks
  std::uint64_t cycles = 0;    ///< simulated; 0 for a backend without a clock
  double seconds = 0;          ///< processor time, summed over threads and the programs they run
  Bins classes;
  std::vector<Mismatch> mismatches;  ///< the first few, by case

  /// What makes it the same set in another shard.
  std::string key() const { return unit + '\n' + set + '\n' + backend + '\n' + mode; }
};

/// Everything one command checked.
struct Report {
  std::string command;
  std::string suite;
  std::uint64_t seed = 0;
  Shard shard;
  bool bins_must_be_hit = false;  ///< an empty bin is a failure
  std::vector<SetReport> sets;
  Bins corners;  ///< rare branches of the hardware model, by name; none when no backend of the run observes them

  /// Adds up the classes of every set of a unit: unit -> class -> hits.
  std::map<std::string, Bins> classes() const;
};

/// The totals of a report, and the reasons beside mismatches why it fails.
struct Verdict {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::vector<std::string> empty_bins;  ///< "class axis_compressor/upper-on-grid", "corner stack_overflow"
  std::vector<std::string> empty_sets;  ///< sets that checked nothing: each counts as a failure
  bool pass() const { return failed == 0 && passed > 0; }
};

/// Bins and empty sets are judged only of a whole run: one shard of many need not hit them all.
Verdict judge(const Report& report);

/// Adds a part of a set's cases to the rest. Keys and totals must agree.
void accumulate(SetReport& into, const SetReport& part);

}  // namespace cbvh::testbench
