// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram_config.h"

#include <bit>

#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {
namespace {

class Checks {
 public:
  void range(const char* field, std::uint64_t value, std::uint64_t least, std::uint64_t most) {
    if (value < least || value > most) {
      report(field, value, std::to_string(least) + " to " + std::to_string(most));
    }
  }
  void power_of_two(const char* field, std::uint64_t value, std::uint64_t least, std::uint64_t most) {
    if (!std::has_single_bit(value) || value < least || value > most) {
      report(field, value, "a power of two from " + std::to_string(least) + " to " + std::to_string(most));
    }
  }

  std::optional<std::string> first;

 private:
  void report(const std::string& field, std::uint64_t value, const std::string& wanted) {
    if (!first) first = "DRAM " + field + ": " + std::to_string(value) + ", want " + wanted;
  }
};

}  // namespace

std::optional<std::string> DramConfig::check() const {
  constexpr unsigned kMostClocks = 100000;
  Checks checks;
  for (const DramTimingEntry& entry : kLpddr3Timing) checks.range(entry.name, timing.*entry.value, 1, kMostClocks);
  checks.range("RL", timing.read_latency, timing.write_latency, kMostClocks);
  checks.range("core_clock_mhz", core_clock_mhz, 1, kMostClocks);
  checks.power_of_two("channels", channels, 1, 8);
  checks.power_of_two("banks", banks, 1, 32);
  checks.power_of_two("row_bytes", row_bytes, kBytesPerLine, 1u << 16);
  checks.power_of_two("capacity_bytes", capacity_bytes, std::uint64_t{1} * channels * banks * row_bytes,
                      std::uint64_t{kBytesPerLine} << kLineAddressBits);
  checks.power_of_two("interleave_bytes", interleave_bytes, kBytesPerLine, row_bytes);
  checks.range("read_queue_depth", read_queue_depth, 1, 64);
  checks.range("write_queue_depth", write_queue_depth, 1, 64);
  checks.range("write_high", write_high, 1, write_queue_depth);
  checks.range("write_low", write_low, 0, write_high - 1u);
  checks.range("batch_lines", batch_lines, 1, kMostClocks);
  checks.range("idle_clocks", idle_clocks, 0, kMostClocks);
  checks.range("overtakes", overtakes, 1, kMostClocks);
  checks.range("outstanding", outstanding, 1, 4096);
  checks.range("answer_latency", answer_latency, 1, kMostClocks);
  checks.range("jitter", jitter, 0, kMostClocks);
  return checks.first;
}

std::uint64_t DramConfig::cycles_at_peak(std::uint64_t bytes) const {
  const std::uint64_t bytes_per_microsecond = std::uint64_t{1} * channels * kBytesPerClock * timing.clock_mhz;
  return (bytes * core_clock_mhz + bytes_per_microsecond - 1) / bytes_per_microsecond;
}

}  // namespace cbvh::rtl
