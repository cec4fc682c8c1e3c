// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rtl_model/kernel/commit_key.h"
#include "rtl_model/kernel/random.h"
#include "rtl_model/memory/dram_address.h"
#include "rtl_model/memory/dram_channel.h"
#include "rtl_model/memory/line_port.h"
#include "rtl_model/memory/line_store.h"

namespace cbvh::rtl {

/// LPDDR3 memory behind any number of ports, in place of IdealLineMemory. A clock it takes at most one read and one
/// write for each channel, the read first, from the ports in turn, and answers each port at most once, in the order of
/// that port's requests.
///
/// A read of a line that waits to be written gets the written words from the write queue, and goes to the pins only for
/// words that are missing there. A write to a line that waits to be written joins it. (A full queue takes neither.) A
/// write to a line that waits to be read is not taken before that read is on the pins. So what a read returns is fixed
/// when it is taken, and the model looks it up then. Memory it needs: the queues, and `outstanding` lines for each
/// port.
class Dram {
 public:
  /// `config` must pass its check().
  Dram(const DramConfig& config, const std::vector<LinePort>& ports);
  Dram(const Dram&) = delete;
  Dram& operator=(const Dram&) = delete;

  void tick() {
    ++cycle_;
    phase_ += config_.timing.clock_mhz;
    while (phase_ >= config_.core_clock_mhz) {
      phase_ -= config_.core_clock_mhz;
      ++clock_;
      for (Lane& lane : lanes_) {
        if (lane.channel.wake() <= clock_) step(lane.channel);
      }
    }
    answer_ports();
    take_requests();
  }
  void commit(CommitKey) {}

  /// Nothing waits: every request is on the pins, every answer given.
  bool idle() const;
  /// The first access beyond the capacity: the run is void. (It is answered with zeros.)
  std::optional<std::string> error() const { return error_; }

  const DramConfig& config() const { return config_; }
  std::uint64_t cycles() const { return cycle_; }
  DramCounts counts() const;  ///< of all channels
  const DramPortCounts& port_counts(std::size_t port) const { return ports_[port].counts; }
  std::uint64_t forwarded_reads() const { return forwarded_reads_; }
  std::uint64_t merged_writes() const { return merged_writes_; }
  /// Core cycles that the lines on the pins would take if the data bus never rested.
  std::uint64_t bound_cycles() const;
  std::vector<DramStatistic> statistics() const;

  LineStore store;
  DramHooks hooks;

 private:
  static constexpr std::uint64_t kPending = ~std::uint64_t{0};
  struct Answer {
    std::uint64_t taken_cycle = 0;
    std::uint64_t ready_cycle = kPending;
    bool read = false;
    LineData data;
  };
  struct Port {
    LinePort link;
    std::vector<Answer> answers;  ///< a ring
    unsigned head = 0;
    unsigned size = 0;
    DramPortCounts counts;
  };

  /// A channel and who waits in front of it.
  struct Lane {
    DramChannel channel;
    std::uint32_t wanting[2] = {};         ///< ports with a read, with a write for it, a bit each
    unsigned next_port[2] = {};            ///< whose turn it is
    std::optional<std::uint64_t> awaited;  ///< a line that is not read any more until a waiting write to it is taken
  };

  void step(DramChannel& channel);
  void answer_ports() {
    for (Port& port : ports_) {
      if (port.size > 0 && port.answers[port.head].ready_cycle <= cycle_ && port.link.answers->can_push()) give(port);
    }
  }
  void give(Port& port);
  void take_requests();
  void take_one(Lane& lane, bool write);
  bool take(unsigned index, Lane& lane);
  bool take_write(Port& port, const DramPlace& place, Lane& lane);
  bool take_read(Port& port, unsigned index, const DramPlace& place, Lane& lane);
  void refuse(unsigned index);
  DramRequest request_for(std::uint32_t line, const DramPlace& place);
  Answer& new_answer(Port& port, bool read);
  void make_ready(Port& port, Answer& answer, std::uint64_t cycle);
  std::uint64_t cycle_of(std::uint64_t clock) const;

  const DramConfig config_;
  const DramAddressMap map_;
  std::vector<Lane> lanes_;
  std::vector<Port> ports_;
  SplitMix64 random_;
  std::uint64_t cycle_ = 0;  ///< of the core
  std::uint64_t clock_ = 0;  ///< of the command bus
  std::uint64_t phase_ = 0;  ///< time since that clock, in core cycles * MHz of the core
  std::uint64_t age_ = 0;
  std::uint64_t answers_given_ = 0;
  std::uint64_t forwarded_reads_ = 0;
  std::uint64_t merged_writes_ = 0;
  std::optional<std::string> error_;
};

}  // namespace cbvh::rtl
