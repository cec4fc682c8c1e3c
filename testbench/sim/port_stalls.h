// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "rtl_model/kernel/stall.h"
#include "rtl_model/memory/line_link.h"

namespace cbvh::testbench {

/// Stands between the modules and the ports of a memory and holds requests and answers back at random, without changing
/// their order: whatever a design computes must not depend on it. Without a seed it is not there: ports() are the
/// design's own.
class PortStalls {
 public:
  PortStalls(const std::vector<rtl::LinePort>& inner, std::optional<std::uint64_t> seed) {
    if (!seed) ports_ = inner;
    for (std::size_t i = 0; seed && i < inner.size(); ++i) {
      entries_.push_back(std::make_unique<Entry>(inner[i], *seed * 1000 + 2 * i));
      ports_.push_back(entries_.back()->outer.port());
    }
  }

  /// What the memory is connected to.
  const std::vector<rtl::LinePort>& ports() const { return ports_; }

  void tick() {
    for (const auto& entry : entries_) entry->tick();
  }
  void commit(rtl::CommitKey key) {
    for (const auto& entry : entries_) {
      entry->outer.requests.commit(key);
      entry->outer.answers.commit(key);
    }
  }

 private:
  struct Entry {
    Entry(const rtl::LinePort& port, std::uint64_t seed)
        : inner(port), requests(rtl::StallPattern::bursts(seed)), answers(rtl::StallPattern::bursts(seed + 1)) {}

    void tick() {
      const bool hold_request = requests.stalls();
      const bool hold_answer = answers.stalls();
      if (!hold_request && inner.requests->can_pop() && outer.requests.can_push())
        outer.requests.push(inner.requests->pop());
      if (!hold_answer && outer.answers.can_pop() && inner.answers->can_push())
        inner.answers->push(outer.answers.pop());
    }

    rtl::LinePort inner;
    rtl::LineLink outer;
    rtl::StallPattern requests;
    rtl::StallPattern answers;
  };

  std::vector<std::unique_ptr<Entry>> entries_;
  std::vector<rtl::LinePort> ports_;
};

}  // namespace cbvh::testbench
