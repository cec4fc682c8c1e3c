// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/tree/compressed_tree.h"
#include "rtl_model/kernel/utilisation.h"
#include "testbench/report/json.h"

namespace cbvh::testbench {

/// One purpose of memory traffic, counted at the memory's ports beside the analytic model.
struct TrafficRow {
  std::string purpose;
  std::uint64_t reads = 0;  ///< 64-byte accesses
  std::uint64_t writes = 0;
  std::uint64_t model_bytes = 0;  ///< golden/update/traffic.h, this purpose's share
  std::int64_t explained_bytes =
      0;  ///< what whole lines cost beyond it, computed without the simulation where possible
  std::string explanation;

  std::uint64_t counted_bytes() const { return 64 * (reads + writes); }
  std::int64_t difference() const {
    return static_cast<std::int64_t>(counted_bytes()) - static_cast<std::int64_t>(model_bytes);
  }
  bool exact() const { return difference() == explained_bytes; }
};

/// One figure of the memory.
struct MemoryStatistic {
  std::string name;
  std::string unit;
  std::string description;
  double value;
};

/// What a simulation of the pipeline, or of the refit unit, gave.
struct SimResult {
  std::string scene;
  std::string output;
  std::uint64_t triangles = 0;
  std::uint64_t leaves = 0;
  std::uint64_t pairs = 0;
  int min_scale = 0;

  bool identical = false;  ///< memory holds the golden's tree and ID array, bit for bit
  std::string difference;  ///< the first, if it does not
  std::string digest;      ///< of the tree in memory; empty for float pairs
  std::string golden_digest;
  std::uint64_t repairs = 0;
  std::uint64_t golden_repairs = 0;
  std::optional<golden::CompressedTree> tree;

  std::uint64_t cycles = 0;
  std::vector<std::pair<std::string, std::uint64_t>> phases;  ///< name and the cycle in which it ended
  double clock_mhz = 1000;
  double bound_cycles = 0;  ///< that the traffic needs at the memory's peak; 0: the memory has none
  std::uint64_t runs = 0;
  std::uint64_t merge_passes = 0;
  std::vector<TrafficRow> traffic;
  std::uint64_t baseline_bytes = 0;  ///< the model's, of a separate top-down pass
  std::vector<MemoryStatistic> memory;
  std::vector<rtl::ModuleUse> utilisation;
  double seconds = 0;  ///< of the host

  double milliseconds() const { return static_cast<double>(cycles) / (clock_mhz * 1000); }
  double over_bound() const { return bound_cycles > 0 ? static_cast<double>(cycles) / bound_cycles : 0; }
  std::uint64_t counted_bytes() const;
  double traffic_ratio() const { return static_cast<double>(counted_bytes()) / static_cast<double>(baseline_bytes); }
  /// The same, had every purpose moved no more bytes than the model says.
  double model_ratio() const;
  bool traffic_explained() const;
  bool pass() const { return identical && repairs == golden_repairs && traffic_explained(); }
};

/// Says from the utilisation and the memory's figures what holds the machine up.
std::string bottleneck(const SimResult& result);

Json to_json(const SimResult& result);
std::string to_text(const SimResult& result);

}  // namespace cbvh::testbench
