// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "rtl_model/datapath/lbvh_payloads.h"

namespace cbvh::rtl {

/// Synthesis parameters of the run merger. The defaults are the paper's, section 5.3.
struct MergeConfig {
  std::uint64_t scratchpad_bytes = 256U << 10U;
  std::uint64_t minimum_buffer_records = 8;  ///< of a run, when as many runs as possible are merged
  /// Read one after the other for one run, if its buffer holds two such batches: the more, the fewer rows of DRAM are
  /// opened. With 2, 4, 8 and 16 the merge of 106 runs takes 1.09, 1.06, 1.05 and 1.05 times the cycles that
  /// LPDDR3-1600 is busy with its data, and more gain nothing.
  std::uint64_t refill_lines = 16;
  std::uint64_t outstanding = 64;    ///< lines asked for and not here yet
  std::uint64_t table_runs = 16384;  ///< runs of a scene; 57 bits each

  /// The first field that does not fit the others, or nothing.
  constexpr std::string_view inconsistent_field() const {
    if (scratchpad_bytes % kBytesPerLine != 0) return "scratchpad_bytes";
    if (minimum_buffer_records == 0 || minimum_buffer_records % kRecordsPerLine != 0 || most_runs() < 2)
      return "minimum_buffer_records";
    if (refill_lines == 0) return "refill_lines";
    if (outstanding == 0) return "outstanding";
    if (table_runs == 0) return "table_runs";
    return {};
  }

  constexpr std::uint64_t scratchpad_lines() const { return scratchpad_bytes / kBytesPerLine; }
  /// How many runs can be merged at once.
  constexpr std::uint64_t most_runs() const { return scratchpad_lines() / (minimum_buffer_records / kRecordsPerLine); }
};

/// How the scratchpad is divided among the runs of one merge.
struct BufferShape {
  std::uint64_t batch_lines;   ///< read one after the other
  std::uint64_t buffer_lines;  ///< of each run: a multiple of batch_lines, of two if there is room

  static constexpr BufferShape of(const MergeConfig& config, std::uint64_t runs) {
    const std::uint64_t share = config.scratchpad_lines() / runs;
    const std::uint64_t batch = std::min(config.refill_lines, std::max<std::uint64_t>(1, share / 2));
    return {batch, share / batch * batch};
  }
};

}  // namespace cbvh::rtl
