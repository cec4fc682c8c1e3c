// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <set>

#include "vectors/generate/sort_items.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Records of the scratchpad that the cases are made for: small, so that episodes are short.
constexpr std::size_t kSorterCapacity = 16;

/// Replacement selection from its definition: an ordered set of what is held.
struct RunSorter {
  using Stimulus = rtl::SortItem;
  using Response = rtl::SortItem;
  static constexpr std::string_view kName = "run_sorter";
  static constexpr std::string_view kSummary = "records into sorted runs, in a scratchpad (here of 16 records)";
  static constexpr std::string_view kLatencyText = "min(n, 16) + 1, then 1 each";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kSortClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_sort_items(case_class, random, kSorterCapacity);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> items, const Parameters&) {
    std::vector<Expected<Response>> sorted;
    std::uint32_t start = 0;  // cycle in which the first record of a scene is taken
    while (!items.empty()) {
      const auto last = std::find_if(items.begin(), items.end(), [](const Stimulus& item) { return bool(item.last); });
      if (last == items.end()) throw golden::InputError("last", "not set in the last record");
      const auto count = static_cast<std::size_t>(last - items.begin()) + 1;
      const auto filled = static_cast<std::uint32_t>(std::min(count, kSorterCapacity));
      for (const Response& item : sort_scene(items.first(count))) {
        sorted.push_back({item, start + filled + 1});
        ++start;
      }
      start += filled;
      items = items.subspan(count);
    }
    return sorted;
  }

 private:
  struct Held {
    std::size_t run;
    std::uint64_t code;
    std::size_t arrival;
    auto operator<=>(const Held&) const = default;
  };

  static std::vector<Response> sort_scene(std::span<const Stimulus> items) {
    std::set<Held> held;
    std::vector<Held> given;
    for (std::size_t arrival = 0; arrival < items.size(); ++arrival) {
      Held next{0, items[arrival].record.code.value(), arrival};
      if (held.size() == kSorterCapacity) {
        given.push_back(*held.begin());
        held.erase(held.begin());
        next.run = given.back().run + (next.code < given.back().code ? 1 : 0);
      }
      held.insert(next);
    }
    given.insert(given.end(), held.begin(), held.end());
    std::vector<Response> sorted;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const bool last = i + 1 == given.size();
      const bool last_of_run = last || given[i + 1].run != given[i].run;
      sorted.push_back({items[given[i].arrival].record, rtl::UInt<1>(last_of_run), rtl::UInt<1>(last)});
    }
    return sorted;
  }
};

}  // namespace cbvh::vectors
