// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "vectors/faces/writing.h"
#include "vectors/generate/emit_steps.h"

namespace cbvh::vectors {

/// The primitive-ID array to memory.
struct IdWriter {
  using Stimulus = IdStep;
  using Response = WriteEvent;
  static constexpr std::string_view kName = "id_writer";
  static constexpr std::string_view kSummary = "writes the primitive-ID array to memory, 16 entries a line";
  static constexpr std::string_view kLatencyText = "1 an entry, 6 at the end";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kIdClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_id_steps(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    if (steps.empty() || !steps.back().entry.last) throw golden::InputError("last", "not set in the last entry");
    WriteEvents writer(steps.front().base.value());
    rtl::LineWords words{};
    std::size_t filled = 0;
    for (const Stimulus& step : steps) {
      const std::uint64_t mark = step.entry.last_of_leaf ? golden::kLastOfLeaf : 0;
      words[filled++] = rtl::UInt<32>(step.entry.id.value() + mark);
      if (filled < rtl::kWordsPerLine && !step.entry.last) {
        writer.pass();
        continue;
      }
      writer.write(words, (1U << filled) - 1, bool(step.entry.last));
      words = {};
      filled = 0;
    }
    return writer.events;
  }
};

}  // namespace cbvh::vectors
