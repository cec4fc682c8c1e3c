// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/line_memory.h"
#include "vectors/generate/gather_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Fetches primitives by number, and reads a line only if it is not the one held at its place.
struct PrimitiveGatherer {
  using Stimulus = GatherStep;
  using Response = GatherEvent;
  static constexpr std::string_view kName = "primitive_gatherer";
  static constexpr std::string_view kSummary = "primitives by number, neighbours sharing reads of lines (8 held)";
  static constexpr std::string_view kLatencyText = "that of memory and 2, the first";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kGatherClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_gather_steps(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    const LineMemory memory(steps);
    std::vector<Expected<Response>> primitives;
    std::vector<Expected<Response>> accesses;
    std::map<std::uint64_t, std::uint64_t> held;  // line of the array, by place
    rtl::ReadCommand array;
    bool ended = true;
    for (const GatherInput& input : commands_of(steps)) {
      if (bool(input.is_id) == ended) throw golden::InputError("is_id", "IDs follow their array up to the last one");
      ended = input.is_id && input.id.last;
      if (!input.is_id) {
        array = input.array;
        held.clear();
        continue;
      }
      const bool in_range = input.id.id.raw() < array.items.raw();
      const std::uint64_t word = input.id.id.raw() * 10;
      GatherEvent event;
      event.primitive.id = input.id.id;
      event.primitive.last = input.id.last;
      event.mark = {input.id.last_of_leaf, input.id.last, rtl::UInt<1>(in_range)};
      if (in_range) {
        for (std::size_t i = 0; i < 9; ++i) {
          event.primitive.vertex[i / 3][i % 3] = {memory.word(array.first_line.raw() * 16 + word + i)};
        }
        for (std::uint64_t line = word / 16; line <= (word + 9) / 16; ++line) {
          const auto [place, fresh] = held.try_emplace(line % kGathererLines, line);
          if (!fresh && place->second == line) continue;
          place->second = line;
          GatherEvent access;
          access.access = rtl::UInt<1>(1);
          access.line = rtl::LineAddress(array.first_line.raw() + line);
          accesses.push_back({access, kLatencyNotStated});
        }
      }
      primitives.push_back({event, kLatencyNotStated});
    }
    if (!ended) throw golden::InputError("last", "no ID is marked last");
    primitives.insert(primitives.end(), accesses.begin(), accesses.end());
    return primitives;
  }
};

}  // namespace cbvh::vectors
