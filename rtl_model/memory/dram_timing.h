// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

/// What a DRAM's commands must keep between them, as data. Source: JEDEC JESD209-3 (LPDDR3), in whole clocks of 800 MHz
/// as Ramulator 1.0 has them for LPDDR3_1600 (src/LPDDR3.h; typical tRCD and tRP, write latency set A).
namespace cbvh::rtl {

/// In clocks of the command bus.
struct DramTiming {
  unsigned clock_mhz;
  unsigned burst;
  unsigned column_to_column;
  unsigned read_latency;
  unsigned strobe_delay;
  unsigned write_latency;
  unsigned activate_to_column;
  unsigned precharge;
  unsigned precharge_all;
  unsigned activate_to_precharge;
  unsigned activate_to_activate;
  unsigned read_to_precharge;
  unsigned write_to_read;
  unsigned write_recovery;
  unsigned other_bank_activate;
  unsigned four_activates;
  unsigned refresh_interval;
  unsigned refresh_all;
  unsigned refresh_bank;

  /// First read command of a line to its last word.
  constexpr unsigned line_read() const { return column_to_column + read_latency + strobe_delay + burst; }
  /// The three that follow from the data bus's direction: JESD209-3, 4.7 and 4.9. (Ramulator has the last one without
  /// its one clock for the write strobe.)
  constexpr unsigned read_command_to_write() const { return read_latency + strobe_delay + burst + 1 - write_latency; }
  constexpr unsigned write_command_to_read() const { return write_latency + 1 + burst + write_to_read; }
  constexpr unsigned write_command_to_precharge() const { return write_latency + 1 + burst + write_recovery; }

  bool operator==(const DramTiming&) const = default;
};

constexpr unsigned kBytesPerClock = 8;  ///< 32 data wires, both edges
constexpr unsigned kBurstsPerLine = 2;  ///< of eight words: 64 bytes

struct DramTimingEntry {
  const char* name;  ///< JEDEC's
  unsigned DramTiming::*value;
  unsigned clocks;  ///< LPDDR3-1600, a 4 Gb die
  const char* meaning;
};

constexpr std::array<DramTimingEntry, 19> kLpddr3Timing = {{
    {"fCK", &DramTiming::clock_mhz, 800, "command clock in MHz; data moves on both edges"},
    {"BL/2", &DramTiming::burst, 4, "a burst of eight on the data bus"},
    {"tCCD", &DramTiming::column_to_column, 4, "read to read, write to write"},
    {"RL", &DramTiming::read_latency, 12, "read to the strobe of its first word"},
    {"tDQSCK", &DramTiming::strobe_delay, 2, "from there to the word"},
    {"WL", &DramTiming::write_latency, 6, "write to the strobe of its first word"},
    {"tRCD", &DramTiming::activate_to_column, 15, "activate to read or write in the row"},
    {"tRPpb", &DramTiming::precharge, 15, "precharge of one bank to its next activate"},
    {"tRPab", &DramTiming::precharge_all, 17, "precharge of all banks to any activate or refresh"},
    {"tRAS", &DramTiming::activate_to_precharge, 34, "activate to precharge of the same bank"},
    {"tRC", &DramTiming::activate_to_activate, 48, "activate to activate of the same bank"},
    {"tRTP", &DramTiming::read_to_precharge, 6, "read to precharge of its bank"},
    {"tWTR", &DramTiming::write_to_read, 6, "last written word to read, any bank"},
    {"tWR", &DramTiming::write_recovery, 12, "last written word to precharge of its bank"},
    {"tRRD", &DramTiming::other_bank_activate, 8, "activate to activate of another bank"},
    {"tFAW", &DramTiming::four_activates, 40, "in which at most four banks are activated"},
    {"tREFI", &DramTiming::refresh_interval, 3120, "refresh to refresh of all banks, on average"},
    {"tRFCab", &DramTiming::refresh_all, 104, "refresh of all banks to the next command"},
    {"tRFCpb", &DramTiming::refresh_bank, 48, "refresh of one bank to its next command"},
}};

enum class DramDensity { gigabit_4, gigabit_6, gigabit_8 };

constexpr DramTiming lpddr3_1600(DramDensity density = DramDensity::gigabit_4) {
  DramTiming timing{};
  for (const DramTimingEntry& entry : kLpddr3Timing) timing.*entry.value = entry.clocks;
  if (density != DramDensity::gigabit_4) {
    timing.refresh_all = 168;
    timing.refresh_bank = 72;
  }
  return timing;
}

}  // namespace cbvh::rtl
