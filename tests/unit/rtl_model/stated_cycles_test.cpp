// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The cycles that the golden faces state for the collectors and the modules' cycles agree on generated streams.
#include <gtest/gtest.h>

#include "rtl_model/compress/lazy_treelet_collector.h"
#include "rtl_model/compress/treelet_collector.h"
#include "tests/support/unit_run.h"
#include "vectors/units/treelet_collector.h"

namespace cbvh {
namespace {

template <class Unit, class Module>
std::size_t expect_stated_cycles(int levels) {
  std::size_t checks = 0;
  const vectors::Parameters parameters{6, levels};
  for (std::size_t case_class = 0; case_class < Unit::kClasses.size(); ++case_class) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      vectors::Random random(seed * 100 + case_class);
      const auto jobs = Unit::generate(case_class, random, parameters);
      const auto expected = Unit::respond(jobs, parameters);
      const auto observed = testing::run_unit<rtl::StreamJob, rtl::FinalPair<6>>(
          jobs, {}, [levels](auto& in, auto& out) { return std::make_unique<Module>(in, out, levels); },
          expected.size());
      EXPECT_EQ(observed.responses.size(), expected.size());
      for (std::size_t i = 0; i < std::min(observed.responses.size(), expected.size()); ++i) {
        EXPECT_EQ(observed.given[i] - observed.accepted[0], expected[i].latency)
            << Unit::kClasses[case_class] << " seed " << seed << " D " << levels << " response " << i;
        EXPECT_EQ(observed.responses[i], expected[i].response);
        if (::testing::Test::HasFailure()) return checks;
        ++checks;
      }
    }
  }
  return checks;
}

TEST(StatedCycles, treelet_collector_gives_every_final_pair_in_its_stated_cycle) {
  for (const int levels : {1, 2, 3, 4, 6}) {
    EXPECT_GT((expect_stated_cycles<vectors::TreeletCollector<6>, rtl::TreeletCollector<rtl::MachineBits, 6>>(levels)),
              1000u);
  }
}
TEST(StatedCycles, lazy_treelet_collector_gives_every_final_pair_in_its_stated_cycle) {
  for (const int levels : {1, 2, 3, 4, 6}) {
    EXPECT_GT((expect_stated_cycles<vectors::LazyTreeletCollector<6>, rtl::LazyTreeletCollector<rtl::MachineBits, 6>>(
                  levels)),
              1000u);
  }
}

}  // namespace
}  // namespace cbvh
