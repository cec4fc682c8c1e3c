// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "rtl_model/datapath/node_words.h"
#include "rtl_model/memory/line_store.h"
#include "testbench/backend/responses.h"
#include "vectors/line_payloads.h"
#include "vectors/unit.h"

/// Ports of units that read arrays from memory.
namespace cbvh::testbench {

/// Fills memory as the steps say, and gives their commands.
template <class Command>
std::vector<Command> prepare(std::span<const vectors::MemoryStep<Command>> steps, rtl::LineStore& store) {
  std::vector<Command> commands;
  for (const auto& step : steps) {
    if (step.act) {
      commands.push_back(step.command);
      continue;
    }
    for (std::size_t i = 0; i < rtl::kWordsPerLine; ++i) {
      store.poke(step.line.value() * rtl::kWordsPerLine + i, static_cast<std::uint32_t>(step.words[i].value()));
    }
  }
  return commands;
}

/// vectors::with_bits for units whose pairs lie packed in memory; their sets have no other N.
template <class F>
Responses with_packed_bits(int bits, F&& f) {
  return vectors::with_bits(bits, [&](auto n) {
    if constexpr (decltype(n)::value <= rtl::kMostPackedBits) {
      return f(n);
    } else {
      return Responses(0);
    }
  });
}

/// A port's channels.
struct LineChannels {
  rtl::Channel<rtl::LineRequest> requests;
  rtl::Channel<rtl::LineData> answers;
  rtl::LinePort port() { return {&requests, &answers}; }
  void commit(rtl::CommitKey key) {
    requests.commit(key);
    answers.commit(key);
  }
};

/// Notes the accesses that memory takes. List it behind the channels it watches.
class AccessMonitor {
 public:
  explicit AccessMonitor(const LineChannels& channels) : requests_(channels.requests) {}

  void commit(rtl::CommitKey) {
    if (requests_.pops() != accesses.size()) accesses.push_back(requests_.last_popped());
  }

  std::vector<rtl::LineRequest> accesses;

 private:
  const rtl::Channel<rtl::LineRequest>& requests_;
};

}  // namespace cbvh::testbench
