// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/sorted_runs.h"

#include <algorithm>

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSingleRecord,
  kOneRun,
  kEqualCodes,
  kFewCodes,
  kEndsOfTheCurve,
  kOneAfterTheOther,
  kInReverse,
  kAsManyAsFit,
  kOneMoreThanFit,
  kTwoPasses,
  kThreePasses,
  kRunsOfOne,
  kOneLongRun,
  kAnyRuns
};

constexpr std::uint64_t kCodes = std::uint64_t{1} << rtl::kMortonBits;

std::size_t run_count(std::size_t case_class, Random& random, std::size_t most_runs) {
  switch (case_class) {
    case kSingleRecord:
    case kOneRun:
      return 1;
    case kAsManyAsFit:
      return most_runs;
    case kOneMoreThanFit:
      return most_runs + 1;
    case kTwoPasses:
      return most_runs + 2 + random.below(most_runs * most_runs - most_runs - 1);
    case kThreePasses:
      return most_runs * most_runs + 1 + random.below(most_runs);
    default:
      return 1 + random.below(2 * most_runs);
  }
}

std::size_t run_length(std::size_t case_class, std::size_t run, Random& random) {
  switch (case_class) {
    case kSingleRecord:
    case kRunsOfOne:
      return 1;
    case kOneRun:
      return 1 + random.below(24);
    case kThreePasses:
      return 1 + random.below(2);
    case kTwoPasses:
      return 1 + random.below(3);
    case kOneLongRun:
      return run == 0 ? 12 + random.below(12) : 1 + random.below(3);
    default:
      return 1 + random.below(7);
  }
}

std::uint64_t any_code(std::size_t case_class, std::size_t run, std::uint64_t some, Random& random) {
  switch (case_class) {
    case kEqualCodes:
      return some;
    case kFewCodes:
      return random.below(3) * (some / 2);
    case kEndsOfTheCurve:
      return random.flip() ? random.below(2) : kCodes - 1 - random.below(2);
    case kOneAfterTheOther:
      return run * 1000 + random.below(1000);
    case kInReverse:
      return kCodes - 1 - run * 1000 - random.below(1000);
    default:
      return random.one_in(3) ? some : random.below(kCodes);
  }
}

}  // namespace

std::vector<rtl::SortItem> make_sorted_runs(std::size_t case_class, Random& random, std::size_t most_runs) {
  std::vector<rtl::SortItem> items;
  const std::uint64_t some = random.below(kCodes);
  const std::size_t runs = run_count(case_class, random, most_runs);
  for (std::size_t run = 0; run < runs; ++run) {
    std::vector<std::uint64_t> codes(run_length(case_class, run, random));
    for (std::uint64_t& code : codes) code = any_code(case_class, run, some, random);
    std::sort(codes.begin(), codes.end());
    for (const std::uint64_t code : codes) {
      rtl::SortItem& item = items.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        item.record.box.lower[axis] = rtl::Float32::of_raw(random.next());
        item.record.box.upper[axis] = rtl::Float32::of_raw(random.next());
      }
      item.record.code = rtl::UInt<rtl::kMortonBits>(code);
      item.record.id = rtl::Pointer::of_raw(random.next());
    }
    items.back().last_of_run = rtl::UInt<1>(1);
  }
  items.back().last = rtl::UInt<1>(1);
  return items;
}

}  // namespace cbvh::vectors
