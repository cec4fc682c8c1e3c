// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rtl_model/memory/dram_timing.h"

namespace cbvh::rtl {

enum class DramRefresh {
  all_banks,  ///< every tREFI the channel closes all rows and waits tRFCab (as Ramulator does)
  per_bank,   ///< every tREFI / banks one bank, in turn, while the others work
};

/// What can be chosen of a Dram. The defaults are the paper's memory: LPDDR3-1600, two channels of 32 bits with a 4 Gb
/// die each, behind a design of 1 GHz.
struct DramConfig {
  DramTiming timing = lpddr3_1600();
  unsigned core_clock_mhz = 1000;  ///< of the design that ticks it; any ratio to the command clock is kept exactly

  unsigned channels = 2;                                  ///< power of two
  unsigned banks = 8;                                     ///< of a channel; power of two
  unsigned row_bytes = 4096;                              ///< of a bank; power of two
  std::uint64_t capacity_bytes = std::uint64_t{1} << 30;  ///< of all channels; power of two

  unsigned interleave_bytes = 128;  ///< consecutive bytes in one channel; power of two from a line to a row
  bool bank_hash =
      true;  ///< the bank's number is XORed with the row's, so that streams a power of two apart do not meet

  unsigned read_queue_depth = 48;   ///< lines waiting in a channel; at most 64
  unsigned write_queue_depth = 64;  ///< likewise
  unsigned write_high = 48;         ///< a channel turns to writing when so many lines wait ...
  unsigned write_low = 8;           ///< ... and back to reading, if reads wait, when no more than these are left
  unsigned batch_lines = 64;        ///< a direction is kept for so many lines while the other's are waiting
  unsigned idle_clocks = 32;        ///< without a read after which a channel writes below the high mark as well
  unsigned overtakes =
      32;  ///< lines that may overtake an older one of their bank, for another row, while a row is open
  DramRefresh refresh = DramRefresh::all_banks;

  unsigned outstanding = 64;    ///< answers a port may wait for: the size of its reorder buffer in lines
  unsigned answer_latency = 2;  ///< core cycles from the last word (or taking the write) to the answer in the channel

  unsigned jitter = 0;     ///< at most so many more cycles, at random: for tests that no result depends on timing
  std::uint64_t seed = 0;  ///< of the jitter
  std::uint64_t lose_answer = 0;  ///< n: the nth answer is dropped; 0: none. A fault, to show that deadlocks are found

  /// The first field that cannot be, found and wanted.
  std::optional<std::string> check() const;
  /// Core cycles that so many bytes take if the data buses never rest.
  std::uint64_t cycles_at_peak(std::uint64_t bytes) const;
  /// Of a bank.
  std::uint64_t rows() const { return capacity_bytes / channels / banks / row_bytes; }
};

}  // namespace cbvh::rtl
