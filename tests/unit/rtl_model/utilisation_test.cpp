// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/kernel/utilisation.h"

#include <gtest/gtest.h>

#include "rtl_model/bits/fields.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {
namespace {

struct Item {
  UInt<8> value;
  UInt<1> last;
  static constexpr auto fields() { return field_list("value", &Item::value, "last", &Item::last); }
};

constexpr auto same = [](const Item& item) { return item; };

/// Two stages in a row, whose ends the test holds.
struct Design {
  Channel<Item> in;
  Channel<Item> between;
  Channel<Item> out;
  StagePipeline<Item, Item, 3, same> first{in, between};
  StagePipeline<Item, Item, 2, same> second{between, out};

  auto parts() { return std::tie(in, first, between, second, out); }
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("in", "source", "first", in);
    visit("between", "first", "second", between);
    visit("out", "second", "sink", out);
  }
};

struct Bench {
  Design design;
  Netlist netlist;
  Clock<Design> clock{design};

  Bench() { netlist.add(design); }
  void push(unsigned value, bool last) { design.in.push({UInt<8>(value), UInt<1>(last)}); }
};

const ModuleUse& row(const std::vector<ModuleUse>& rows, const std::string& module) {
  for (const ModuleUse& use : rows) {
    if (use.module == module) return use;
  }
  throw std::runtime_error("no row " + module);
}

TEST(Utilisation, tells_busy_cycles_from_stalls_on_either_side_and_idle_ones) {
  Bench bench;
  Utilisation utilisation(bench.netlist);
  // Items enter in cycles 0 and 5; the sink takes nothing before cycle 20.
  for (int cycle = 0; cycle < 40; ++cycle) {
    if (cycle == 0 || cycle == 5 || cycle == 6 || cycle == 7) bench.push(1, cycle == 7);
    if (cycle >= 20 && bench.design.out.can_pop()) bench.design.out.pop();
    bench.clock.step();
    utilisation.observe();
  }
  const auto rows = utilisation.rows();
  ASSERT_EQ(rows.size(), 4u);
  for (const ModuleUse& use : rows)
    EXPECT_EQ(use.busy + use.stalled_on_input + use.stalled_on_output + use.idle, 40u) << use.module;
  const ModuleUse& source = row(rows, "source");
  EXPECT_EQ(source.busy, 4u);
  EXPECT_EQ(source.stalled_on_input, 4u) << "cycles 1 to 4";
  EXPECT_EQ(source.idle, 32u);
  // Taken in cycles 1, 6, 7, 8, given in 3, 8, 9, 10.
  const ModuleUse& first = row(rows, "first");
  EXPECT_EQ(first.busy, 7u) << "1, 3, 6, 7, 8, 9, 10";
  EXPECT_EQ(first.stalled_on_input, 3u) << "2, 4, 5";
  // Given two items in cycles 5 and 10, its output is full from cycle 11 until the sink has taken one in cycle 20.
  const ModuleUse& second = row(rows, "second");
  EXPECT_EQ(second.stalled_on_output, 10u) << "11 to 20";
}

TEST(Utilisation, deadlock_names_who_holds_back_and_who_waits) {
  Bench bench;
  for (unsigned i = 0; i < 8; ++i) {
    if (bench.design.in.can_push()) bench.push(i, false);
    bench.clock.step();
  }
  for (int i = 0; i < 20; ++i) {
    if (bench.design.in.can_push()) bench.push(9, false);
    bench.clock.step();
  }
  const std::uint64_t moved = bench.netlist.transfers();
  for (int i = 0; i < 20; ++i) bench.clock.step();
  EXPECT_EQ(bench.netlist.transfers(), moved) << "nothing moves while the sink takes nothing";
  // 2 items are in `out`, 1 in the second stage, 2 in `between`, 2 in the first stage.
  EXPECT_EQ(bench.netlist.waiting(), (std::vector<std::string>{"source waits for first to take in (7 so far)",
                                                               "first waits for second to take between (3 so far)",
                                                               "second waits for sink to take out (0 so far)"}));
}

TEST(Utilisation, a_stream_whose_last_item_has_passed_waits_for_nothing) {
  Bench bench;
  bench.push(1, false);
  const auto run = [&] {
    for (int i = 0; i < 10; ++i) {
      if (bench.design.out.can_pop()) bench.design.out.pop();
      bench.clock.step();
    }
  };
  run();
  EXPECT_EQ(bench.netlist.waiting(), (std::vector<std::string>{"first waits for in from source (1 so far)",
                                                               "second waits for between from first (1 so far)",
                                                               "sink waits for out from second (1 so far)"}));
  bench.push(2, true);
  run();
  EXPECT_TRUE(bench.netlist.waiting().empty());
}

}  // namespace
}  // namespace cbvh::rtl
