// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The yardstick of the area table adds as the host's floats do.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "testbench/gateware/process.h"
#include "testbench/gateware/simulator.h"
#include "testbench/output.h"
#include "vectors/random.h"

namespace cbvh::testbench {
namespace {

using Operands = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t host_sum(const Operands& operands) {
  const float sum = std::bit_cast<float>(operands.first) + std::bit_cast<float>(operands.second);
  return std::isnan(sum) ? 0x7FC00000U : std::bit_cast<std::uint32_t>(sum);
}

/// Every pair of values near an edge of the format, then random ones: any, close to each other, exponents close to each
/// other, subnormal or nearly so.
std::vector<Operands> operands(std::size_t random_ones) {
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t bits :
       {0U,          1U,          2U,          0x7FFFFFU,   0x800000U,   0x800001U,   0xFFFFFFU,
        0x1000000U,  0x32FFFFFFU, 0x33800000U, 0x33800001U, 0x34000000U, 0x3F7FFFFFU, 0x3F800000U,
        0x3F800001U, 0x7F000000U, 0x7F7FFFFFU, 0x7F800000U, 0x7F800001U, 0x7FC00000U}) {
    edges.push_back(bits);
    edges.push_back(bits | 0x80000000U);
  }
  std::vector<Operands> all;
  for (const std::uint32_t a : edges)
    for (const std::uint32_t b : edges) all.emplace_back(a, b);
  vectors::Random random(1);
  const auto word = [&] { return static_cast<std::uint32_t>(random.next()); };
  for (std::size_t i = 0; i < random_ones; ++i) {
    const std::uint32_t a = word();
    switch (i % 4) {
      case 0:
        all.emplace_back(a, word());
        break;
      case 1:
        all.emplace_back(a, a ^ (word() & 0x80000007U));
        break;
      case 2: {
        const auto apart = static_cast<std::uint32_t>(random.between(-28, 28));
        all.emplace_back(a, ((a + (apart << 23)) & 0x7F800000U) | (word() & 0x807FFFFFU));
        break;
      }
      default:
        all.emplace_back(a & 0x81FFFFFFU, word() & 0x81FFFFFFU);
    }
  }
  return all;
}

TEST(Binary32Adder, sums_are_those_of_the_host_for_edges_and_random_operands) {
  if (!why_no_simulator().empty()) GTEST_SKIP() << why_no_simulator();
  const TemporaryFolder folder;
  const std::string model = folder.path() + "/adder.vvp";
  const std::string log = folder.path() + "/log";
  ASSERT_EQ(run_program({"iverilog", "-g2005", "-Wall", "-o", model, "-s", "adder_bench", "-y", "fpga/gateware", "-y",
                         "fpga/gateware/reference", "fpga/gateware/reference/adder_bench.v"},
                        log),
            0)
      << read_text_file(log);
  const auto all = operands(60'000);
  {
    std::ofstream file(folder.path() + "/operands");
    for (const Operands& pair : all) file << fmt::format("{:08x} {:08x}\n", pair.first, pair.second);
  }
  ASSERT_EQ(run_program({"vvp", "-n", model, "+file=" + folder.path() + "/operands"}, log), 0) << read_text_file(log);
  std::istringstream sums(read_text_file(log));
  std::size_t compared = 0;
  for (std::string line; std::getline(sums, line); ++compared) {
    ASSERT_LT(compared, all.size());
    ASSERT_EQ(line, fmt::format("{:08x}", host_sum(all[compared])))
        << fmt::format("{:08x} + {:08x}", all[compared].first, all[compared].second);
  }
  EXPECT_EQ(compared, all.size());
}

}  // namespace
}  // namespace cbvh::testbench
