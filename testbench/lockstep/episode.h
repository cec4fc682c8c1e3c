// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "rtl_model/kernel/channel.h"
#include "vectors/format/payload_codec.h"

namespace cbvh::testbench {

/// What the channels of a C++ module did, clock by clock.
enum class Flow : std::uint8_t { to_unit, from_unit };

struct ChannelLog {
  /// Of a clock. ready: there is room for a push; valid: there is something to pop.
  enum Bit : unsigned { ready = 1, valid = 2, push = 4, pop = 8 };

  std::string name;  ///< of the twin's ports NAME_valid, NAME_ready, NAME_data
  Flow flow;
  std::size_t width;                 ///< bits of the data
  std::vector<std::uint8_t> clocks;  ///< Bits of each
  std::vector<std::string> items{};  ///< hex, in the order of their pushes; those that came to the head
};

/// From reset on. All logs are of the same clocks.
struct Episode {
  std::vector<ChannelLog> channels;
};

/// A payload's packed bits in hex, most significant digit first.
std::string packed_hex(const vectors::PayloadCodec& codec, const void* payload);

/// Cuts the clocks at the end in which nothing happens any more, and those from where on something was pushed that
/// never came to a head.
void cut_episode(Episode& episode);

/// Logs one channel. In a rtl::Clock it stands behind it.
template <class T>
class Probe {
 public:
  Probe(const rtl::Channel<T>& channel, std::string name, Flow flow)
      : channel_(channel), log_{std::move(name), flow, vectors::payload_codec<T>().width, {}} {}

  void tick() {
    pops_ = channel_.pops();
    pushes_ = channel_.pushes();
    log_.clocks.push_back(static_cast<std::uint8_t>((channel_.can_push() ? ChannelLog::ready : 0U) |
                                                    (channel_.can_pop() ? ChannelLog::valid : 0U)));
    if (channel_.can_pop() && log_.items.size() == pops_) {
      log_.items.push_back(packed_hex(vectors::payload_codec<T>(), &channel_.front()));
    }
  }
  void commit(rtl::CommitKey) {
    const unsigned moved =
        (channel_.pushes() != pushes_ ? ChannelLog::push : 0U) | (channel_.pops() != pops_ ? ChannelLog::pop : 0U);
    moved_ = moved != 0;
    log_.clocks.back() = static_cast<std::uint8_t>(log_.clocks.back() | moved);
  }

  bool moved() const { return moved_; }  ///< in the last clock
  const ChannelLog& log() const { return log_; }

 private:
  const rtl::Channel<T>& channel_;
  ChannelLog log_;
  std::uint64_t pops_ = 0;
  std::uint64_t pushes_ = 0;
  bool moved_ = false;
};

/// Steps the clock until nothing has moved for longer than any stall lasts.
template <class Clock, class... Probes>
Episode record_episode(Clock& clock, const Probes&... probes) {
  constexpr int kIdleClocks = 300;
  for (int idle = 0; idle < kIdleClocks;) {
    clock.step();
    idle = (probes.moved() || ...) ? 0 : idle + 1;
  }
  Episode episode{{probes.log()...}};
  cut_episode(episode);
  return episode;
}

}  // namespace cbvh::testbench
