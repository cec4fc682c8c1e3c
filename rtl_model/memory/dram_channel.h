// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "rtl_model/memory/dram_config.h"
#include "rtl_model/memory/dram_queue.h"
#include "rtl_model/memory/dram_statistics.h"
#include "rtl_model/memory/dram_trace.h"

namespace cbvh::rtl {

/// A read on its way: where its answer belongs and the clock after its last word.
struct DramReadIssued {
  unsigned port;
  unsigned answer;
  std::uint64_t data_end;
};

/// One channel and its controller: a command a clock at most. Requests to open rows go first, the oldest of them first,
/// then the oldest that needs a row (FR-FCFS); but once `overtakes` lines have overtaken a bank's oldest request, that
/// one is next in its bank. Reads and writes take turns in batches; meanwhile rows are opened for the other direction
/// in banks that this one leaves alone. Paper 5.3 (the memory that Ramulator simulates there).
///
/// Nothing happens in most clocks: wake() is the first one in which something can, and the only ones to step.
class DramChannel {
 public:
  DramChannel(const DramConfig& config, unsigned index, const DramHooks& hooks);

  const DramQueue& reads() const { return reads_; }
  const DramQueue& writes() const { return writes_; }
  /// All requests are on the pins. (Their data may be on its way.)
  bool idle() const { return reads_.empty() && writes_.empty() && second_burst_.clock == kNever; }
  const DramCounts& counts() const { return counts_; }
  std::uint64_t wake() const { return wake_; }

  void push(bool write, const DramRequest& request);
  /// Adds words to a write that waits.
  void merge(int slot, UInt<kWordsPerLine> mask) {
    writes_[slot].mask = UInt<kWordsPerLine>::of_raw(writes_[slot].mask.raw() | mask.raw());
  }
  /// The clock `clock`, not before wake(). At most one read is issued in it.
  std::optional<DramReadIssued> step(std::uint64_t clock);

 private:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
  /// When a bank may be given its next commands.
  struct Bank {
    std::uint32_t row = 0;
    unsigned overtaken = 0;  ///< lines since it was opened that were not the bank's oldest
    std::uint64_t activate_from = 0;
    std::uint64_t column_from = 0;
    std::uint64_t precharge_from = 0;
  };
  struct SecondBurst {
    std::uint64_t clock = kNever;
    DramCommandKind kind{};
    unsigned bank = 0;
  };

  bool due(std::uint64_t from, std::uint64_t clock);
  void command(DramCommandKind kind, unsigned bank, std::uint64_t clock);
  void choose_direction(std::uint64_t clock);
  std::uint32_t hit_banks(const DramQueue& queue) const;
  int pick_column(const DramQueue& queue, std::uint64_t clock);
  DramReadIssued issue_column(DramQueue& queue, int slot, std::uint64_t clock);
  bool prepare_row(DramQueue& queue, std::uint32_t banks, std::uint64_t clock);
  bool is_open(unsigned bank) const { return (open_banks_ >> bank & 1u) != 0; }
  void activate(unsigned number, std::uint32_t row, std::uint64_t clock);
  void precharge(unsigned number, std::uint64_t clock);
  void close(unsigned number, std::uint64_t activate_from);
  bool refresh(std::uint64_t clock);
  bool refresh_all(std::uint64_t clock);
  bool refresh_next_bank(std::uint64_t clock);

  const DramConfig& config_;
  const DramTiming& timing_;
  const unsigned index_;
  const DramHooks& hooks_;

  DramQueue reads_;
  DramQueue writes_;
  std::vector<Bank> banks_;
  std::uint32_t open_banks_ = 0;       ///< a bit each
  std::uint32_t overtaken_banks_ = 0;  ///< likewise: as often as is allowed
  SecondBurst second_burst_;
  std::uint64_t wake_ = 0;

  std::uint64_t read_from_ = 0;             ///< first clock of the next read command
  std::uint64_t write_from_ = 0;            ///< likewise
  std::uint64_t activate_from_ = 0;         ///< likewise, of any bank
  std::array<std::uint64_t, 4> windows_{};  ///< of the last four activates: the first clock after tFAW
  std::size_t oldest_window_ = 0;

  bool writing_ = false;         ///< the direction being served
  bool last_was_write_ = false;  ///< of the data bus
  unsigned batch_ = 0;           ///< lines since the direction changed
  std::uint64_t no_read_since_ = 0;

  const std::uint64_t refresh_period_;
  std::uint64_t next_refresh_;
  std::uint64_t refresh_from_ = 0;  ///< first clock of the next refresh of a bank
  unsigned refresh_bank_ = 0;       ///< whose turn it is
  std::uint32_t refreshing_ = 0;    ///< banks that only a refresh may use now, a bit each
  DramCounts counts_;
};

}  // namespace cbvh::rtl
