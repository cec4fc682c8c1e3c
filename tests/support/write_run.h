// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rtl_model/datapath/lbvh_payloads.h"
#include "rtl_model/kernel/clock.h"
#include "tests/support/stalling_port.h"

/// A module that writes a stream to memory and reports.
namespace cbvh::testing {

struct WriteRun {
  std::vector<rtl::WriteReport> reports;
  std::vector<std::uint32_t> words;  ///< memory from `base` on, as many as asked for
  std::uint64_t writes = 0;
  std::uint64_t cycles = 0;
  bool finished = false;
};

/// What untouched memory holds.
constexpr std::uint32_t kUntouched = 0xDEADBEEF;

/// `Module` takes (items, requests, answers, reports, base). Until `reports` reports have come.
template <class Module, class Item>
WriteRun run_writer(std::span<const Item> items, std::size_t reports, std::uint64_t base, std::size_t words,
                    const Disturbance& disturbance = {}) {
  rtl::Channel<Item> in;
  rtl::Channel<rtl::WriteReport> out;
  StallingPort port(disturbance);
  Module unit(in, *port.near().requests, *port.near().answers, out, rtl::LineAddress(base));
  rtl::IdealLineMemory memory({port.far()}, 1U << 20);
  rtl::Clock clock(unit, in, out, port, memory);
  auto source = disturbance.source_stalls ? rtl::StallPattern::bursts(disturbance.seed) : rtl::StallPattern::never();
  auto sink = disturbance.sink_stalls ? rtl::StallPattern::bursts(disturbance.seed + 1) : rtl::StallPattern::never();
  const std::uint64_t first = base * rtl::kWordsPerLine;
  for (std::size_t i = 0; i < words; ++i) memory.store.poke(first + i, kUntouched);
  WriteRun run;
  std::size_t sent = 0;
  run.finished = run_until(clock, disturbance, 1000 + 50 * items.size(), [&] {
    if (!source.stalls() && sent < items.size() && in.can_push()) in.push(items[sent++]);
    if (!sink.stalls() && out.can_pop()) run.reports.push_back(out.pop());
    return run.reports.size() == reports;
  });
  run.cycles = clock.cycle();
  run.writes = memory.writes;  // at the report everything is there
  for (std::size_t i = 0; i < words; ++i) run.words.push_back(memory.store.peek(first + i));
  return run;
}

}  // namespace cbvh::testing
