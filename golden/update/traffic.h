// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace cbvh::golden {

/// External memory traffic of two ways to an updated quantized tree.
struct Traffic {
  std::uint64_t baseline_bytes;   ///< a float tree written, then read and compressed top-down
  std::uint64_t streaming_bytes;  ///< compressed on the way out, with its backtracks
  double ratio() const { return static_cast<double>(streaming_bytes) / static_cast<double>(baseline_bytes); }
};

struct UpdateTraffic {
  Traffic lbvh;
  Traffic refit;
};

/// The traffic model of the paper's section 5.2. LBVH reads primitives (40 B), sorts their boxes (64 B), writes IDs (4
/// B) and pairs (16 B); refit reads pairs, IDs and primitives and writes pairs. The baseline writes 64-byte float
/// pairs, reads them back and writes 16 bytes. A backtrack reads and writes 64 bytes, the smallest access.
UpdateTraffic update_traffic(std::uint64_t primitives, std::uint64_t pairs, std::uint64_t backtracks);

}  // namespace cbvh::golden
