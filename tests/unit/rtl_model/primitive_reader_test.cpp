// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/primitive_reader.h"

#include <gtest/gtest.h>

#include <vector>

#include "rtl_model/memory/ideal_line_memory.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

std::uint32_t word(std::uint64_t index) { return static_cast<std::uint32_t>(SplitMix64(index).next()) & 0x7FFFFFF; }

/// Primitive i is words 10 i .. 10 i + 9.
std::vector<Primitive> expected(std::size_t count) {
  std::vector<Primitive> primitives(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < 9; ++j) primitives[i].vertex[j / 3][j % 3] = Float32::of_raw(word(10 * i + j));
    primitives[i].id = Pointer(word(10 * i + 9));
    primitives[i].last = UInt<1>(i + 1 == count);
  }
  return primitives;
}

struct Observed {
  std::vector<Primitive> primitives;
  std::vector<std::uint64_t> given;  ///< cycle in which each could be taken
  std::uint64_t reads = 0;
  std::uint64_t most_in_flight = 0;
};

Observed read(std::size_t count, unsigned outstanding, const testing::Disturbance& disturbance, unsigned latency = 4) {
  constexpr std::uint64_t kFirstLine = 17;
  Channel<LineRequest> requests;
  Channel<LineData> answers;
  Channel<Primitive> primitives;
  PrimitiveReader reader(requests, answers, primitives, LineAddress(kFirstLine), count, outstanding);
  IdealLineMemory memory({{&requests, &answers}}, 1 << 16, latency, disturbance.source_stalls ? 20 : 0,
                         disturbance.seed);
  for (std::uint64_t i = 0; i < 10 * count; ++i) memory.store.poke(kFirstLine * 16 + i, word(i));
  Clock clock(requests, answers, primitives, reader, memory);
  SplitMix64 order(disturbance.seed);
  auto sink = disturbance.sink_stalls ? StallPattern::bursts(disturbance.seed) : StallPattern::never();
  Observed observed;
  const std::uint64_t deadline = 1000 + 200 * count;
  std::uint64_t drain = 0;
  while (clock.cycle() < deadline && drain < 64) {
    if (!sink.stalls() && primitives.can_pop()) {
      observed.primitives.push_back(primitives.pop());
      observed.given.push_back(clock.cycle());
    }
    drain = observed.primitives.size() >= count ? drain + 1 : 0;
    disturbance.shuffled_order ? clock.step_shuffled(order) : clock.step();
    observed.most_in_flight = std::max(observed.most_in_flight, requests.pushes() - answers.pops());
  }
  observed.reads = memory.reads;
  return observed;
}

TEST(PrimitiveReader, gives_every_primitive_once_and_reads_every_line_once_whatever_stalls) {
  for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 16U, 17U, 100U, 803U}) {
    for (const auto& disturbance : testing::stall_matrix(count)) {
      for (const unsigned outstanding : {1U, 2U, 32U}) {
        const Observed observed = read(count, outstanding, disturbance);
        ASSERT_EQ(observed.primitives, expected(count)) << count;
        ASSERT_EQ(observed.reads, (count * 40 + 63) / 64);
        ASSERT_LE(observed.most_in_flight, outstanding);
      }
    }
  }
}

TEST(PrimitiveReader, gives_a_primitive_a_clock_even_if_memory_is_slow_as_long_as_enough_reads_are_in_flight) {
  for (const unsigned latency : {4U, 20U, 40U}) {
    const Observed observed = read(500, 32, {}, latency);
    ASSERT_EQ(observed.given.size(), 500U);
    for (std::size_t i = 0; i < 500; ++i) ASSERT_EQ(observed.given[i], latency + 3 + i) << latency;
  }
}

TEST(PrimitiveReader, has_as_many_reads_in_flight_as_it_may) {
  for (const unsigned outstanding : {1U, 2U, 7U, 32U}) {
    const Observed observed = read(400, outstanding, {}, 60);
    EXPECT_EQ(observed.most_in_flight, outstanding);
    // 250 lines; each is asked for when the answer to the one `outstanding` before it has been taken, 62 cycles later.
    EXPECT_NEAR(static_cast<double>(observed.given.back()), 250.0 / outstanding * 62, 62) << outstanding;
  }
}

}  // namespace
}  // namespace cbvh::rtl
