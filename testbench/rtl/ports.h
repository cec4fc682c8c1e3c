// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/stall.h"
#include "testbench/backend/run_options.h"

/// The ends of channels that a test bench holds. They are clocked like modules. Monitors look at what a cycle has moved
/// after its channel has committed, so they must be listed behind the channels they watch.
namespace cbvh::testbench {

/// The seeds of the two ends differ, and differ between cases.
constexpr std::uint64_t source_seed(const RunOptions& options, std::uint64_t number) {
  return options.stall_seed * 2 + number * 0x9E37;
}
constexpr std::uint64_t sink_seed(const RunOptions& options, std::uint64_t number) {
  return source_seed(options, number) + 1;
}
inline rtl::StallPattern source_stalls(const RunOptions& options, std::uint64_t number) {
  const bool stalls = options.stalls == Stalls::source || options.stalls == Stalls::both;
  return stalls ? rtl::StallPattern::bursts(source_seed(options, number)) : rtl::StallPattern::never();
}

/// Decides, cycle by cycle, whether a sink holds back: in bursts, and besides for 64 of every 256 clocks, which is so
/// long that the output of a slow unit fills, too. The seed says where in the 256 it starts.
class SinkStalls {
 public:
  static SinkStalls never() { return SinkStalls(rtl::StallPattern::never(), std::nullopt); }
  static SinkStalls of_seed(std::uint64_t seed) { return SinkStalls(rtl::StallPattern::bursts(seed), seed); }

  /// Call once a cycle.
  bool stalls() {
    const bool in_burst = bursts_.stalls();
    const bool rests = clock_ && (*clock_)++ % 256 >= 192;
    return in_burst || rests;
  }

 private:
  SinkStalls(rtl::StallPattern bursts, std::optional<std::uint64_t> clock) : bursts_(bursts), clock_(clock) {}

  rtl::StallPattern bursts_;
  std::optional<std::uint64_t> clock_;
};
inline SinkStalls sink_stalls(const RunOptions& options, std::uint64_t number) {
  const bool stalls = options.stalls == Stalls::sink || options.stalls == Stalls::both;
  return stalls ? SinkStalls::of_seed(sink_seed(options, number)) : SinkStalls::never();
}

/// Pushes stimuli as fast as it is let.
template <class T>
class Source {
 public:
  Source(rtl::Channel<T>& channel, std::span<const T> items, rtl::StallPattern stalls)
      : channel_(channel), items_(items), stalls_(stalls) {}

  void tick() {
    const bool holds_back = stalls_.stalls();
    if (holds_back || next_ == items_.size() || !channel_.can_push()) return;
    channel_.push(items_[next_++]);
  }
  void commit(rtl::CommitKey) {}

 private:
  rtl::Channel<T>& channel_;
  std::span<const T> items_;
  rtl::StallPattern stalls_;
  std::size_t next_ = 0;
};

/// Takes responses as fast as its stalls let it, and notes when.
template <class T>
class Sink {
 public:
  Sink(rtl::Channel<T>& channel, SinkStalls stalls) : channel_(channel), stalls_(stalls) {}

  void tick() {
    const bool holds_back = stalls_.stalls();
    if (holds_back || !channel_.can_pop()) return;
    items.push_back(channel_.pop());
    cycles.push_back(cycle_);
  }
  void commit(rtl::CommitKey) { ++cycle_; }

  std::vector<T> items;
  std::vector<std::uint64_t> cycles;  ///< of each item

 private:
  rtl::Channel<T>& channel_;
  SinkStalls stalls_;
  std::uint64_t cycle_ = 0;
};

/// Counts the stimuli that the unit takes, and notes when it does.
template <class T>
class AcceptanceMonitor {
 public:
  explicit AcceptanceMonitor(const rtl::Channel<T>& channel) : channel_(channel) {}

  void commit(rtl::CommitKey) {
    if (channel_.pops() != count()) cycles_.push_back(cycle_);
    ++cycle_;
  }

  void reserve(std::size_t stimuli) { cycles_.reserve(stimuli); }
  std::size_t count() const { return cycles_.size(); }
  std::uint64_t first() const { return cycles_.empty() ? 0 : cycles_[0]; }
  std::uint64_t operator[](std::size_t index) const { return cycles_[index]; }

 private:
  const rtl::Channel<T>& channel_;
  std::vector<std::uint64_t> cycles_;
  std::uint64_t cycle_ = 0;
};

/// Notes the cycles in which the unit sends a response, however long the sink then waits.
template <class T>
class SendMonitor {
 public:
  explicit SendMonitor(const rtl::Channel<T>& channel) : channel_(channel) {}

  void commit(rtl::CommitKey) {
    if (channel_.pushes() != cycles.size()) cycles.push_back(cycle_);
    ++cycle_;
  }

  std::vector<std::uint64_t> cycles;

 private:
  const rtl::Channel<T>& channel_;
  std::uint64_t cycle_ = 0;
};

}  // namespace cbvh::testbench
