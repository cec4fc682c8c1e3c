// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/sort_items.h"

#include <algorithm>

namespace cbvh::vectors {
namespace {

enum SortClass : std::size_t {
  kRandom,
  kEqualCodes,
  kFewCodes,
  kAscending,
  kDescending,
  kNearlySorted,
  kSawTooth,
  kSingleRecord,
  kExactlyCapacity,
  kOneMore,
  kSeveralScenes
};
constexpr std::size_t kOrders = kSingleRecord;  ///< classes before it say in which order codes come

constexpr std::uint64_t kCodes = std::uint64_t{1} << rtl::kMortonBits;

rtl::SortItem any_item(std::uint64_t code, Random& random) {
  rtl::SortItem item;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    item.record.box.lower[axis] = rtl::Float32::of_raw(random.next());
    item.record.box.upper[axis] = rtl::Float32::of_raw(random.next());
  }
  item.record.code = rtl::UInt<rtl::kMortonBits>(code);
  item.record.id = rtl::Pointer::of_raw(random.next());
  return item;
}

/// One scene.
void add_scene(std::size_t order, std::size_t count, Random& random, std::vector<rtl::SortItem>& items) {
  const std::uint64_t some = random.below(kCodes);
  const std::uint64_t period = 2 + random.below(40);
  for (std::size_t i = 0; i < count; ++i) {
    const auto code = [&]() -> std::uint64_t {
      switch (order) {
        case kEqualCodes:
          return some;
        case kFewCodes:
          return random.flip() ? random.below(4) * (kCodes / 4) : random.below(3);
        case kAscending:
          return i * period;
        case kDescending:
          return kCodes - 1 - i * period;
        case kNearlySorted:
          return i * 8 + random.below(8 * period);
        case kSawTooth:
          return i % period;
        default:
          return random.below(kCodes);
      }
    };
    items.push_back(any_item(code(), random));
  }
  items.back().last = rtl::UInt<1>(1);
}

enum RunClass : std::size_t { kOnlyRecord, kOneRun, kRunsOfOne, kEvenRuns, kAnyRuns, kPaddedRuns, kSeveralPasses };

std::uint64_t run_length(std::size_t case_class, Random& random) {
  switch (case_class) {
    case kOnlyRecord:
    case kRunsOfOne:
      return 1;
    case kEvenRuns:
      return 2 * (1 + random.below(4));
    default:
      return 1 + random.below(9);
  }
}

}  // namespace

std::vector<rtl::SortItem> make_sort_items(std::size_t case_class, Random& random, std::size_t capacity) {
  std::vector<rtl::SortItem> items;
  const auto any_count = [&] { return 1 + random.below(4 * capacity); };
  switch (case_class) {
    case kSingleRecord:
      add_scene(kRandom, 1, random, items);
      break;
    case kExactlyCapacity:
      add_scene(random.below(kOrders), capacity, random, items);
      break;
    case kOneMore:
      add_scene(random.below(kOrders), capacity + 1, random, items);
      break;
    case kSeveralScenes:
      for (int scenes = random.between(2, 4); scenes-- > 0;) {
        const std::size_t count = 1 + random.below(2 * capacity);
        add_scene(random.below(kOrders), count, random, items);
      }
      break;
    default:
      add_scene(case_class, any_count(), random, items);
  }
  return items;
}

std::vector<RunStep> make_run_steps(std::size_t case_class, Random& random) {
  std::vector<RunStep> steps;
  std::uint64_t first_line = random.below(64);
  for (int passes = case_class == kSeveralPasses ? random.between(2, 4) : 1; passes-- > 0;) {
    const bool padded = case_class == kPaddedRuns || (case_class == kSeveralPasses && random.flip());
    const rtl::RunArea area{rtl::LineAddress(first_line), rtl::LineAddress(padded ? 1 + random.below(5) : 0)};
    const bool one_run = case_class == kOnlyRecord || case_class == kOneRun;
    for (int runs = one_run ? 1 : random.between(1, 6); runs-- > 0;) {
      for (std::uint64_t left = run_length(case_class, random); left-- > 0;) {
        RunStep step{any_item(random.below(kCodes), random), area};
        step.item.last_of_run = rtl::UInt<1>(left == 0);
        step.item.last = rtl::UInt<1>(left == 0 && runs == 0);
        steps.push_back(step);
      }
    }
    first_line += 200 + random.below(64);
  }
  return steps;
}

}  // namespace cbvh::vectors
