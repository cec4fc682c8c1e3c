// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/kernel/random.h"

namespace cbvh::rtl {

/// Decides, cycle by cycle, whether one end of a channel holds back: in bursts of random length, about half of the
/// time.
class StallPattern {
 public:
  static StallPattern never() { return StallPattern(false, 0); }
  static StallPattern bursts(std::uint64_t seed) { return StallPattern(true, seed); }

  /// Call once a cycle.
  bool stalls() {
    if (!enabled_) return false;
    if (left_ == 0) {
      stalling_ = !stalling_;
      left_ = 1 + random_.below(random_.below(4) == 0 ? 24 : 3);
    }
    --left_;
    return stalling_;
  }

 private:
  StallPattern(bool enabled, std::uint64_t seed) : random_(seed), enabled_(enabled) {}

  SplitMix64 random_;
  std::uint64_t left_ = 0;
  bool enabled_;
  bool stalling_ = false;
};

}  // namespace cbvh::rtl
