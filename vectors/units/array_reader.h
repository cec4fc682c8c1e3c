// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/line_memory.h"
#include "vectors/faces/timing.h"
#include "vectors/generate/array_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Cycles from when a reader took its command until the first item, if memory answers after kMemoryLatency.
constexpr std::uint32_t kFirstItemCycles = kMemoryLatency + 3;

/// A reader of an array with `per_line` items to a line; `item_of(memory, first_line, index)` gives one, unmarked.
template <class Item, std::uint64_t per_line, auto item_of>
struct ArrayReaderUnit {
  using Stimulus = ArrayStep;
  using Response = Item;
  static constexpr std::string_view kLatencyText = "7, then one a cycle";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kArrayClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_array_steps(case_class, per_line, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    const LineMemory memory(steps);
    std::vector<Expected<Response>> items;
    std::uint32_t taken = 0;  // the cycle in which the command is
    for (const rtl::ReadCommand& command : commands_of(steps)) {
      if (command.items.raw() == 0) throw golden::InputError("items", "found 0, want at least 1");
      for (std::uint64_t i = 0; i < command.items.raw(); ++i) {
        Item item = item_of(memory, command.first_line.raw(), i);
        item.last = rtl::UInt<1>(i + 1 == command.items.raw());
        items.push_back({item, taken + kFirstItemCycles + static_cast<std::uint32_t>(i)});
      }
      taken = items.back().latency;
    }
    return items;
  }
};

}  // namespace cbvh::vectors
