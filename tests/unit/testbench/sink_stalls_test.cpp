// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/rtl/ports.h"

namespace cbvh::testbench {
namespace {

struct Holds {
  int total = 0;
  int longest = 0;
};

Holds holds_of(SinkStalls stalls, int clocks) {
  Holds holds;
  for (int clock = 0, run = 0; clock < clocks; ++clock) {
    run = stalls.stalls() ? run + 1 : 0;
    holds.total += run != 0 ? 1 : 0;
    holds.longest = std::max(holds.longest, run);
  }
  return holds;
}

TEST(SinkStalls, hold_back_for_64_clocks_on_end_in_every_256_and_about_half_of_the_rest) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    // Wherever the clocks begin, 64 + 255 of them have a whole rest.
    EXPECT_GE(holds_of(SinkStalls::of_seed(seed), 64 + 255).longest, 64) << seed;
    const Holds many = holds_of(SinkStalls::of_seed(seed), 25600);
    EXPECT_GT(many.total, 25600 / 2) << seed;
    EXPECT_LT(many.total, 25600 * 3 / 4) << seed;
    EXPECT_LE(many.longest, 64 + 2 * 24) << seed;
  }
}

TEST(SinkStalls, short_episodes_begin_anywhere_in_the_256_clocks) {
  int resting = 0;
  for (std::uint64_t seed = 0; seed < 256; ++seed) {
    resting += holds_of(SinkStalls::of_seed(seed), 32).total == 32 ? 1 : 0;
  }
  EXPECT_GE(resting, 33);  // those that begin in a rest, 32 clocks before its end or more
  EXPECT_LT(resting, 64);
}

TEST(SinkStalls, of_a_source_or_of_none_never_hold_back) {
  RunOptions options;
  for (const Stalls stalls : {Stalls::none, Stalls::source}) {
    options.stalls = stalls;
    EXPECT_EQ(holds_of(sink_stalls(options, 7), 1000).total, 0);
  }
  for (const Stalls stalls : {Stalls::sink, Stalls::both}) {
    options.stalls = stalls;
    EXPECT_GE(holds_of(sink_stalls(options, 7), 1000).longest, 64);
  }
}

}  // namespace
}  // namespace cbvh::testbench
