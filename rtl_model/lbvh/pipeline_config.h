// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rtl_model/datapath/lbvh_payloads.h"
#include "rtl_model/lbvh/merge_config.h"
#include "rtl_model/memory/line_link.h"

namespace cbvh::rtl {

/// Configuration wires and synthesis parameters of the LBVH pipeline. The scene's box and registers are computed by the
/// driver, as in the paper.
struct LbvhConfig {
  LineAddress primitives;              ///< first line of the primitives
  std::uint64_t count = 0;             ///< of primitives, at least one
  std::array<RunArea, 2> run_areas{};  ///< passes over the runs write into them in turn
  LineAddress ids;                     ///< first line of the primitive-ID array
  LineAddress pairs;                   ///< first line of the 16-byte node pairs
  LineAddress float_pairs;             ///< first line of the 64-byte float pairs, where there are such
  SceneBox scene;
  SceneRegisters registers;

  unsigned reader_outstanding = 32;
  std::size_t sorter_records = 8192;
  MergeConfig merge;
  int treelet = 4;
  std::size_t held_lines = 128;  ///< of the node writer
};

/// A port of a pipeline, and the module behind it.
struct NamedPort {
  std::string module;
  LinePort port;
};

}  // namespace cbvh::rtl
