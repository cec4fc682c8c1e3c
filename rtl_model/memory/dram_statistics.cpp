// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram_statistics.h"

#include "rtl_model/memory/dram.h"

namespace cbvh::rtl {
namespace {

double ratio(double dividend, double divisor) { return divisor == 0 ? 0 : dividend / divisor; }

}  // namespace

DramCounts& DramCounts::operator+=(const DramCounts& other) {
  reads += other.reads;
  writes += other.writes;
  row_hits += other.row_hits;
  row_misses += other.row_misses;
  row_conflicts += other.row_conflicts;
  activates += other.activates;
  precharges += other.precharges;
  refreshes += other.refreshes;
  turnarounds += other.turnarounds;
  return *this;
}

std::vector<DramStatistic> Dram::statistics() const {
  std::vector<DramStatistic> table;
  const auto add = [&table](const std::string& name, const char* unit, const char* description, auto value) {
    table.push_back({name, unit, description, static_cast<double>(value)});
  };
  const DramCounts sum = counts();
  const std::uint64_t lines = sum.reads + sum.writes;
  std::uint64_t read_cycles = 0;
  std::uint64_t reads_taken = 0;
  for (const Port& port : ports_) {
    read_cycles += port.counts.read_cycles;
    reads_taken += port.counts.reads;
  }
  add("cycles", "core cycles", "since reset", cycle_);
  add("reads", "lines", "read on the pins", sum.reads);
  add("writes", "lines", "written on the pins", sum.writes);
  add("bytes_read", "bytes", "on the pins", sum.reads * kBytesPerLine);
  add("bytes_written", "bytes", "on the pins", sum.writes * kBytesPerLine);
  add("forwarded_reads", "lines", "answered from the write queues alone", forwarded_reads_);
  add("merged_writes", "lines", "that joined a waiting write to the same line", merged_writes_);
  add("row_hits", "lines", "whose row was open", sum.row_hits);
  add("row_misses", "lines", "whose bank was closed", sum.row_misses);
  add("row_conflicts", "lines", "in whose bank another row was open", sum.row_conflicts);
  add("activates", "commands", "rows opened", sum.activates);
  add("precharges", "commands", "rows closed, or all rows of a channel", sum.precharges);
  add("refreshes", "commands", "of a channel, or of a bank", sum.refreshes);
  add("turnarounds", "times", "a data bus changed its direction", sum.turnarounds);
  add("busy_clocks", "command clocks", "with data on the bus, all channels added up",
      lines * kBurstsPerLine * config_.timing.burst);
  add("bound_cycles", "core cycles", "that the lines on the pins need at the least", bound_cycles());
  add("read_latency", "core cycles", "from taking a read to its answer, average",
      ratio(static_cast<double>(read_cycles), static_cast<double>(reads_taken)));
  add("bandwidth", "GB/s", "on the pins, average",
      ratio(static_cast<double>(lines * kBytesPerLine) * config_.core_clock_mhz, static_cast<double>(cycle_) * 1000));
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const std::string name = "port_" + std::to_string(i);
    add(name + "_reads", "lines", "taken", ports_[i].counts.reads);
    add(name + "_writes", "lines", "taken", ports_[i].counts.writes);
  }
  return table;
}

}  // namespace cbvh::rtl
