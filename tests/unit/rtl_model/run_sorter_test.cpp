// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/run_sorter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

/// A scene of records with these codes; ids count, so that they tell the order of arrival.
std::vector<SortItem> items_of(const std::vector<std::uint64_t>& codes) {
  std::vector<SortItem> items;
  for (const std::uint64_t code : codes) {
    SortItem item;
    item.record.code = UInt<kMortonBits>(code);
    item.record.id = Pointer(items.size());
    item.record.box.lower[1] = Float32::of_raw(items.size() * 77);
    items.push_back(item);
  }
  items.back().last = UInt<1>(1);
  return items;
}

/// Replacement selection from its definition, one scene.
std::vector<SortItem> expected_runs(const std::vector<SortItem>& items, std::size_t capacity) {
  using Held = std::tuple<std::uint64_t, std::uint64_t, std::size_t>;  // run, code, arrival
  std::set<Held> held;
  std::vector<Held> given;
  std::uint64_t run = 0;
  for (std::size_t arrival = 0; arrival < items.size(); ++arrival) {
    std::uint64_t joins = run;
    if (held.size() == capacity) {
      given.push_back(*held.begin());
      held.erase(held.begin());
      run = std::get<0>(given.back());
      joins = items[arrival].record.code.value() < std::get<1>(given.back()) ? run + 1 : run;
    }
    held.emplace(joins, items[arrival].record.code.value(), arrival);
  }
  given.insert(given.end(), held.begin(), held.end());
  std::vector<SortItem> sorted;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool last = i + 1 == given.size();
    const bool ends_run = last || std::get<0>(given[i + 1]) != std::get<0>(given[i]);
    sorted.push_back({items[std::get<2>(given[i])].record, UInt<1>(ends_run), UInt<1>(last)});
  }
  return sorted;
}

/// Merging the runs, the earlier first where codes are equal, must give the stable sort of the scene.
void expect_stable_when_merged(const std::vector<SortItem>& sorted, std::vector<SortItem> items) {
  std::vector<std::tuple<std::uint64_t, std::size_t, std::size_t>> merged;  // code, run, place in the run
  std::size_t run = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    merged.emplace_back(sorted[i].record.code.value(), run, i);
    if (sorted[i].last_of_run) {
      ++run;
    } else {
      ASSERT_LE(sorted[i].record.code.value(), sorted[i + 1].record.code.value()) << "a run is sorted";
    }
  }
  std::sort(merged.begin(), merged.end());
  std::stable_sort(items.begin(), items.end(),
                   [](const SortItem& a, const SortItem& b) { return a.record.code.value() < b.record.code.value(); });
  ASSERT_EQ(merged.size(), items.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    ASSERT_EQ(sorted[std::get<2>(merged[i])].record, items[i].record) << i;
  }
}

enum class Shape { random, few_codes, ascending, descending, equal, nearly_sorted, saw };
constexpr Shape kShapes[] = {Shape::random, Shape::few_codes,     Shape::ascending, Shape::descending,
                             Shape::equal,  Shape::nearly_sorted, Shape::saw};

std::vector<std::uint64_t> codes_of(Shape shape, std::size_t count, SplitMix64& random) {
  constexpr std::uint64_t kCodes = std::uint64_t{1} << kMortonBits;
  std::vector<std::uint64_t> codes;
  for (std::size_t i = 0; i < count; ++i) {
    switch (shape) {
      case Shape::random:
        codes.push_back(random.below(kCodes));
        break;
      case Shape::few_codes:
        codes.push_back(random.below(4) * (kCodes / 4));
        break;
      case Shape::ascending:
        codes.push_back(i * 3);
        break;
      case Shape::descending:
        codes.push_back(kCodes - 1 - i);
        break;
      case Shape::equal:
        codes.push_back(kCodes - 1);
        break;
      case Shape::nearly_sorted:
        codes.push_back(i * 16 + random.below(300));
        break;
      case Shape::saw:
        codes.push_back(i % 37);
        break;
    }
  }
  return codes;
}

testing::Observed<SortItem> sort(const std::vector<SortItem>& items, std::size_t capacity,
                                 const testing::Disturbance& disturbance) {
  return testing::run_unit<SortItem, SortItem>(items, disturbance, [capacity](auto& in, auto& out) {
    return std::make_unique<RunSorter<MachineBits>>(in, out, capacity);
  });
}

TEST(RunSorter, does_replacement_selection_and_its_runs_merge_to_the_stable_sort_whatever_stalls) {
  SplitMix64 random(9);
  std::size_t runs = 0;
  for (const std::size_t capacity : {2U, 3U, 4U, 7U, 16U, 100U}) {
    for (const Shape shape : kShapes) {
      for (const std::size_t count :
           {std::size_t{1}, std::size_t{2}, capacity - 1, capacity, capacity + 1, 2 * capacity, 20 * capacity + 3}) {
        const auto items = items_of(codes_of(shape, count, random));
        const auto want = expected_runs(items, capacity);
        expect_stable_when_merged(want, items);
        for (const auto& disturbance : testing::stall_matrix(count)) {
          ASSERT_EQ(sort(items, capacity, disturbance).responses, want)
              << capacity << ' ' << static_cast<int>(shape) << ' ' << count;
        }
        for (const auto& item : want) runs += item.last_of_run.value();
        if (HasFatalFailure()) return;
      }
    }
  }
  EXPECT_GT(runs, 500U);
}

TEST(RunSorter, sorts_scene_after_scene) {
  SplitMix64 random(10);
  std::vector<SortItem> items;
  std::vector<SortItem> want;
  for (const std::size_t count : {1U, 5U, 8U, 9U, 40U, 3U, 80U, 1U, 1U, 16U}) {
    const auto scene = items_of(codes_of(Shape::few_codes, count, random));
    const auto sorted = expected_runs(scene, 8);
    items.insert(items.end(), scene.begin(), scene.end());
    want.insert(want.end(), sorted.begin(), sorted.end());
  }
  for (const auto& disturbance : testing::stall_matrix()) ASSERT_EQ(sort(items, 8, disturbance).responses, want);
}

std::size_t runs_in(const std::vector<SortItem>& sorted) {
  return static_cast<std::size_t>(
      std::count_if(sorted.begin(), sorted.end(), [](const SortItem& item) { return bool(item.last_of_run); }));
}

TEST(RunSorter, makes_one_run_of_sorted_records_and_runs_of_twice_its_capacity_of_random_ones) {
  SplitMix64 random(11);
  constexpr std::size_t kCapacity = 128;
  const auto runs = [&](Shape shape) {
    return runs_in(sort(items_of(codes_of(shape, 100 * kCapacity, random)), kCapacity, {}).responses);
  };
  EXPECT_EQ(runs(Shape::ascending), 1U);
  EXPECT_EQ(runs(Shape::equal), 1U);
  EXPECT_EQ(runs(Shape::descending), 100U);
  EXPECT_NEAR(static_cast<double>(runs(Shape::random)), 50.0, 3.0);
}

TEST(RunSorter, takes_n_plus_the_smaller_of_n_and_capacity_clocks) {
  SplitMix64 random(12);
  for (const std::size_t capacity : {2U, 16U, 100U}) {
    for (const std::size_t count : {std::size_t{1}, capacity, 4 * capacity + 1}) {
      const auto observed = sort(items_of(codes_of(Shape::random, count, random)), capacity, {});
      const std::size_t filled = std::min(count, capacity);
      ASSERT_EQ(observed.given.size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(observed.accepted[i], observed.accepted[0] + i) << "a record a clock";
        ASSERT_EQ(observed.given[i] - observed.accepted[0], filled + i + 1) << "a result a clock";
      }
    }
  }
}

}  // namespace
}  // namespace cbvh::rtl
