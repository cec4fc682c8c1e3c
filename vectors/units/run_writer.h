// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/timing.h"
#include "vectors/generate/sort_items.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Sorted runs to memory. The events are the lines written and the runs told, in the order and in the cycles in which
/// the unit sends them, counted from when it takes the first area.
struct RunWriter {
  using Stimulus = RunStep;
  using Response = RunEvent;
  static constexpr std::string_view kName = "run_writer";
  static constexpr std::string_view kSummary = "writes sorted runs to memory, two records a line";
  static constexpr std::string_view kLatencyText = "1 a record, 6 at the end";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kRunClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_run_steps(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    std::vector<Expected<Response>> events;
    std::uint32_t cycle = 0;
    std::uint64_t line = 0;
    std::size_t first_of_run = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto& [item, area] = steps[i];
      if (i == 0 || steps[i - 1].item.last) {  // a pass begins
        if (i > 0) ++cycle;
        line = area.first_line.value();
      }
      ++cycle;
      const bool ends_run = bool(item.last_of_run) || bool(item.last);
      const std::size_t of_run = i - first_of_run;
      if (of_run % rtl::kRecordsPerLine == 0 && !ends_run) continue;
      const std::uint64_t of_line = of_run / rtl::kRecordsPerLine;
      events.push_back({line_event(steps.subspan(i - of_run % rtl::kRecordsPerLine, 1 + of_run % rtl::kRecordsPerLine),
                                   line + of_line),
                        cycle});
      if (!ends_run) continue;
      if (item.last) cycle += kMemoryLatency + 1;  // until memory has acknowledged the line
      events.push_back({run_event(line, of_run + 1, bool(item.last)), cycle});
      line += of_line + 1 + area.padding.value();
      first_of_run = i + 1;
    }
    return events;
  }

 private:
  static Response line_event(std::span<const Stimulus> records, std::uint64_t line) {
    Response event;
    event.request.write = rtl::UInt<1>(1);
    event.request.acknowledge = records.back().item.last;
    event.request.line = rtl::LineAddress(line);
    event.request.mask = rtl::UInt<rtl::kWordsPerLine>(records.size() == 1 ? 0x00FF : 0xFFFF);
    std::size_t word = 0;
    for (const Stimulus& step : records) {
      for (const auto& bounds : {step.item.record.box.lower, step.item.record.box.upper}) {
        for (const rtl::Float32 bound : bounds) event.request.words[word++] = rtl::UInt<32>(bound.bits);
      }
      event.request.words[word++] = step.item.record.code;
      event.request.words[word++] = step.item.record.id;
    }
    return event;
  }
  static Response run_event(std::uint64_t line, std::uint64_t records, bool last) {
    Response event;
    event.is_run = rtl::UInt<1>(1);
    event.run = {rtl::LineAddress(line), rtl::UInt<rtl::kPointerBits + 1>(records), rtl::UInt<1>(last)};
    return event;
  }
};

}  // namespace cbvh::vectors
