// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/node_writer.h"

#include <gtest/gtest.h>

#include <map>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/tree/node_pair_format.h"
#include "golden/update/top_down.h"
#include "rtl_model/compress/stream_compressor.h"
#include "tests/support/stalling_port.h"
#include "vectors/convert.h"

namespace cbvh::rtl {
namespace {

using golden::Code;
using testing::Disturbance;
using testing::run_until;
using testing::StallingPort;

constexpr std::uint64_t kFirstLine = 1000;

/// Pair `index` as it lies in memory.
golden::CompressedPair stored_pair(const LineStore& store, std::size_t index) {
  golden::NodePairWords words{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint64_t word = store.peek(kFirstLine * kWordsPerLine + index * 4 + i);
    words[i / 2] |= word << (i % 2 * 32);
  }
  return golden::unpack_node_pair(words);
}

// A stream of requests, told to a plain map as well.

template <int N>
NodePair<N> random_pair(SplitMix64& random) {
  NodePair<N> pair;
  visit_leaves(pair, [&](auto& leaf) { leaf = std::remove_reference_t<decltype(leaf)>::of_raw(random.next()); });
  return pair;
}

template <int N>
struct Traffic {
  std::vector<MemoryRequest<N>> requests;
  std::vector<NodePair<N>> read;             ///< what each read must see at the slot it wants
  std::map<std::size_t, NodePair<N>> pairs;  ///< memory at the end
};

/// Writes of one pair or of several in lines near each other; reads of pairs written before.
template <int N>
Traffic<N> random_traffic(std::size_t count, std::size_t lines, std::uint64_t seed, bool reads = true) {
  SplitMix64 random(seed);
  Traffic<N> traffic;
  std::vector<std::size_t> written;
  for (std::size_t i = 0; i < count; ++i) {
    MemoryRequest<N> request;
    if (reads && !written.empty() && random.below(3) == 0) {
      const std::size_t index = written[written.size() - 1 - random.below(std::min<std::size_t>(written.size(), 40))];
      request.line = UInt<kLineBits>(index / 4);
      request.mask = UInt<4>(1u << index % 4);
      traffic.read.push_back(traffic.pairs[index]);
    } else {
      request.write = UInt<1>(1);
      request.line = UInt<kLineBits>((i / 4 + random.below(lines)) % 5000);
      request.mask = UInt<4>(random.below(3) == 0 ? random.below(16) : 1u << random.below(4));
      for (std::size_t slot = 0; slot < 4; ++slot) {
        if ((request.mask.value() >> slot & 1u) == 0) continue;
        const std::size_t index = request.line.value() * 4 + slot;
        request.pairs[slot] = traffic.pairs[index] = random_pair<N>(random);
        written.push_back(index);
      }
    }
    traffic.requests.push_back(request);
  }
  return traffic;
}

struct Outcome {
  bool finished = false;
  std::uint64_t cycles = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

/// Sends the traffic, then a report, and compares every answer and memory at the report.
template <int N>
Outcome run_traffic(const Traffic<N>& traffic, std::size_t held_lines, const Disturbance& disturbance, unsigned latency,
                    unsigned jitter, Status status = Status::ok) {
  Channel<MemoryRequest<N>> requests;
  Channel<MemoryLine<N>> lines;
  Channel<StreamReport> reports, finished;
  StallingPort port(disturbance);
  NodeWriter<MachineBits, N> writer(requests, lines, reports, port.near(), finished,
                                    {LineAddress(kFirstLine), held_lines});
  IdealLineMemory memory({port.far()}, 10000, latency, jitter, disturbance.seed);
  Clock clock(writer, port, memory, requests, lines, reports, finished);
  auto source = disturbance.source_stalls ? StallPattern::bursts(disturbance.seed + 1) : StallPattern::never();
  auto sink = disturbance.sink_stalls ? StallPattern::bursts(disturbance.seed + 2) : StallPattern::never();
  Outcome outcome;
  std::size_t sent = 0, seen = 0;
  std::vector<std::size_t> slots;
  bool reported = false, compared = false;
  const StreamReport report{Pointer(9), UInt<32>(4), {}, StatusBits(static_cast<std::uint64_t>(status))};
  outcome.finished = run_until(clock, disturbance, 20000 + 200 * traffic.requests.size(), [&] {
    if (!source.stalls() && sent < traffic.requests.size() && requests.can_push()) {
      const auto& request = traffic.requests[sent++];
      if (!request.write) slots.push_back(static_cast<std::size_t>(std::countr_zero(request.mask.value())));
      requests.push(request);
      if (sent == traffic.requests.size()) {
        reports.push(report);  // with the last write, as the stream compressor does
        reported = true;
      }
    }
    if (!sink.stalls() && lines.can_pop()) {
      const auto& line = lines.pop();
      EXPECT_EQ(line.pairs[slots.at(seen)], traffic.read.at(seen));
      ++seen;
    }
    if (!finished.can_pop() || compared) return compared && seen == traffic.read.size();
    compared = true;
    EXPECT_TRUE(reported);
    EXPECT_EQ(finished.front(), report);
    for (const auto& [index, pair] : traffic.pairs) {
      if (status != Status::ok) break;
      EXPECT_TRUE(stored_pair(memory.store, index) == vectors::compressed_pair(pair)) << index;
    }
    return seen == traffic.read.size();
  });
  EXPECT_EQ(seen, traffic.read.size());
  EXPECT_EQ(memory.writes, writer.lines_written);
  EXPECT_EQ(memory.reads, writer.lines_read);
  outcome.cycles = clock.cycle();
  outcome.reads = memory.reads;
  outcome.writes = memory.writes;
  return outcome;
}

template <int N>
void expect_plain_memory(std::size_t held_lines, unsigned latency, unsigned jitter) {
  const auto traffic = random_traffic<N>(3000, 3 + held_lines, held_lines + latency);
  ASSERT_GT(traffic.read.size(), 500u);
  for (const auto& disturbance : testing::stall_matrix()) {
    EXPECT_TRUE(run_traffic(traffic, held_lines, disturbance, latency, jitter).finished);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(NodeWriter, reads_see_the_latest_write_and_memory_is_complete_at_the_report_under_every_stall) {
  expect_plain_memory<6>(1, 4, 0);
  expect_plain_memory<6>(8, 1, 5);
  expect_plain_memory<6>(64, 40, 30);
  expect_plain_memory<2>(16, 10, 9);
}

TEST(NodeWriter, takes_a_request_a_clock) {
  for (const std::size_t held_lines : {1u, 16u, 128u}) {
    const auto traffic = random_traffic<6>(5000, 40, 7, false);
    const auto outcome = run_traffic(traffic, held_lines, {}, 4, 0);
    ASSERT_TRUE(outcome.finished);
    EXPECT_LE(outcome.cycles, traffic.requests.size() + held_lines + 16);
  }
}

TEST(NodeWriter, a_read_of_a_held_pair_costs_no_access_and_its_repair_merges) {
  Traffic<6> traffic;
  SplitMix64 random(1);
  for (std::size_t i = 0; i < 200; ++i) {
    const std::size_t index = i / 4 * 8 + i % 4;  // lines of their own, complete after the last
    MemoryRequest<6> write{UInt<1>(1), UInt<kLineBits>(index / 4), UInt<4>(1u << index % 4), {}};
    write.pairs[index % 4] = random_pair<6>(random);
    traffic.requests.push_back(write);
    if (index % 4 != 3) {
      traffic.requests.push_back({UInt<1>(0), write.line, write.mask, {}});
      traffic.read.push_back(write.pairs[index % 4]);
      write.pairs[index % 4] = random_pair<6>(random);
      traffic.requests.push_back(write);
    }
    traffic.pairs[index] = write.pairs[index % 4];
  }
  const auto outcome = run_traffic(traffic, 16, {}, 4, 0);
  ASSERT_TRUE(outcome.finished);
  EXPECT_EQ(outcome.reads, 0u);
  EXPECT_EQ(outcome.writes, 50u);
}

TEST(NodeWriter, a_refused_tree_writes_nothing_after_its_report) {
  Traffic<6> traffic = random_traffic<6>(10, 1, 3, false);
  const auto outcome = run_traffic(traffic, 64, {}, 4, 0, Status::not_finite);
  ASSERT_TRUE(outcome.finished);
  EXPECT_EQ(outcome.writes, 0u);
}

// Behind the stream compressor.

struct TreeOutcome {
  bool finished = false;
  StreamReport report;
  std::uint64_t writes = 0;
};

template <int N>
TreeOutcome stream_to_memory(const golden::FloatTree& tree, Code code, int levels, std::size_t held_lines,
                             const Disturbance& disturbance, unsigned latency, unsigned jitter) {
  const golden::GridRules rules{N, golden::exactness_limit(tree.largest_magnitude), golden::ScaleRule::equation2};
  const auto registers = vectors::scene_registers(rules, code);
  const auto wanted = golden::compress_top_down(tree, rules, code).pairs;
  Channel<StreamJob> jobs;
  Channel<MemoryRequest<N>> requests;
  Channel<MemoryLine<N>> lines;
  Channel<StreamReport> reports, finished;
  StallingPort port(disturbance);
  StreamCompressor<MachineBits, N> compressor(jobs, requests, lines, reports, levels);
  NodeWriter<MachineBits, N> writer(requests, lines, reports, port.near(), finished,
                                    {LineAddress(kFirstLine), held_lines});
  IdealLineMemory memory({port.far()}, 100000, latency, jitter, disturbance.seed);
  Clock clock(compressor, writer, port, memory, jobs, requests, lines, reports, finished);
  std::size_t sent = 0;
  TreeOutcome outcome;
  outcome.finished = run_until(clock, disturbance, 10000 + 1000 * tree.pairs.size(), [&] {
    if (sent < tree.pairs.size() && jobs.can_push()) jobs.push(vectors::stream_job(tree, sent++, registers));
    return finished.can_pop();
  });
  if (!outcome.finished) return outcome;
  outcome.report = finished.front();
  outcome.writes = memory.writes;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_TRUE(stored_pair(memory.store, i) == wanted[i]) << i;
    if (::testing::Test::HasFailure()) break;
  }
  return outcome;
}

const golden::FloatTree& cloth() {
  static const auto tree = golden::build_lbvh(golden::load_scene("proc:cloth"));
  return tree;
}
const golden::FloatTree& small_cloth() {
  static const auto tree = golden::build_lbvh(golden::load_scene("proc:cloth,sheet=12,height=12"));
  return tree;
}

TEST(NodeWriter, streamed_tree_in_memory_equals_the_packed_top_down_tree) {
  for (const auto& disturbance : testing::stall_matrix()) {
    for (const auto code : {Code::modulo, Code::relative}) {
      for (const int levels : {1, 2, 4}) {
        const std::size_t held_lines = std::size_t{1} << (static_cast<unsigned>(levels) + disturbance.seed % 3);
        EXPECT_TRUE(stream_to_memory<6>(small_cloth(), code, levels, held_lines, disturbance, 6, 9).finished);
        EXPECT_TRUE(stream_to_memory<3>(small_cloth(), code, levels, held_lines, disturbance, 30, 1).finished);
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(NodeWriter, with_128_held_lines_a_tree_of_treelets_takes_at_most_5_percent_more_lines_than_its_pairs_fill) {
  for (const int levels : {2, 3, 4}) {
    const auto outcome = stream_to_memory<6>(cloth(), Code::modulo, levels, 128, {}, 4, 0);
    ASSERT_TRUE(outcome.finished);
    EXPECT_EQ(outcome.report.last_index.value() + 1, cloth().pairs.size());
    const auto ideal = static_cast<double>((cloth().pairs.size() + 3) / 4);
    RecordProperty("lines_D" + std::to_string(levels), std::to_string(outcome.writes));
    EXPECT_LE(static_cast<double>(outcome.writes), 1.05 * ideal);
  }
}

}  // namespace
}  // namespace cbvh::rtl
