// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rtl_model/kernel/netlist.h"

namespace cbvh::rtl {

/// What a module did in each cycle, as seen at its channels.
struct ModuleUse {
  std::string module;
  std::uint64_t busy = 0;               ///< took or gave something
  std::uint64_t stalled_on_input = 0;   ///< nothing moved, all outputs were ready
  std::uint64_t stalled_on_output = 0;  ///< nothing moved, an output was full
  std::uint64_t idle = 0;               ///< before its first and after its last transfer
};

/// Watches the modules of a netlist. Costs nothing to a design that it is not attached to.
class Utilisation {
 public:
  explicit Utilisation(const Netlist& netlist);

  /// Call once a cycle, after the clock's step.
  void observe();

  std::uint64_t cycles() const { return cycles_; }
  /// The four figures of a row add up to cycles().
  std::vector<ModuleUse> rows() const;

 private:
  struct Watched {
    const ChannelState* channel;
    std::uint32_t producer;
    std::uint32_t consumer;
    std::uint64_t pops = 0;
    std::uint64_t pushes = 0;
    bool ready = true;  ///< could be pushed to in the cycle now observed
  };
  struct Module {
    ModuleUse use;
    std::uint64_t stalled_on_input_since = 0;  ///< since the last transfer: stalls if another follows, else idle
    std::uint64_t stalled_on_output_since = 0;
    bool moved = false;
    bool output_full = false;
  };

  std::vector<Watched> channels_;
  std::vector<Module> modules_;
  std::uint64_t cycles_ = 0;
};

}  // namespace cbvh::rtl
