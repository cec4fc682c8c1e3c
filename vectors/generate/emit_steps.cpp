// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/emit_steps.h"

#include <algorithm>

#include "vectors/generate/float_trees.h"
#include "vectors/generate/floats.h"
#include "vectors/generate/intervals.h"

namespace cbvh::vectors {
namespace {

enum EmitClass : std::size_t {
  kSingleRecord,
  kOneLeaf,
  kEndsOfTheCurve,
  kRightSpine,
  kLeftSpine,
  kPartOfASpine,
  kFullTree,
  kFewCodes,
  kNeighbours,
  kLeavesOfSeveral,
  kRandomCodes,
  kNeighbouringFloats,
  kSeveralScenes
};
using Codes = std::vector<std::uint64_t>;

constexpr std::uint64_t kCodes = std::uint64_t{1} << rtl::kMortonBits;

/// 0, 1, 2, 4, ...: each code shares fewer bits with the next; their complements, in order, share more.
Codes spine(bool left) {
  Codes codes;
  for (int bit = -1; bit < rtl::kMortonBits; ++bit) {
    const std::uint64_t code = bit < 0 ? 0 : std::uint64_t{1} << bit;
    codes.push_back(left ? code : kCodes - 1 - code);
  }
  std::sort(codes.begin(), codes.end());
  return codes;
}

Codes random_codes(std::size_t count, std::uint64_t below, std::uint64_t from, Random& random) {
  Codes codes(count);
  for (std::uint64_t& code : codes) code = from + random.below(below);
  return codes;
}

Codes codes_of(std::size_t case_class, Random& random) {
  const std::size_t count = 2 + random.below(10);
  switch (case_class) {
    case kSingleRecord:
      return random_codes(1, kCodes, 0, random);
    case kOneLeaf:
      return Codes(count, random.below(kCodes));
    case kEndsOfTheCurve: {
      Codes codes{0, kCodes - 1};
      while (codes.size() < count) codes.push_back(random.flip() ? random.below(2) : kCodes - 1 - random.below(2));
      return codes;
    }
    case kRightSpine:
      return spine(false);
    case kLeftSpine: {
      Codes codes = spine(true);
      codes.resize(codes.size() - random.below(24));
      return codes;
    }
    case kPartOfASpine: {
      Codes codes = spine(random.flip());
      std::erase_if(codes, [&](std::uint64_t) { return random.one_in(3); });
      return codes.empty() ? Codes{0} : codes;
    }
    case kFullTree: {
      const int levels = random.between(1, 3);
      const std::uint64_t step = std::uint64_t{1} << random.below(26);
      Codes codes;
      for (std::uint64_t i = 0; i < std::uint64_t{1} << levels; ++i) codes.push_back(i * step);
      return codes;
    }
    case kFewCodes:
      return random_codes(count, 4, random.below(kCodes - 4), random);
    case kNeighbours:
      return random_codes(count, 64, random.below(kCodes - 64), random);
    case kLeavesOfSeveral: {
      Codes codes = random_codes(4, kCodes, 0, random);
      while (codes.size() < count) codes.push_back(codes[random.below(4)]);
      return codes;
    }
    default:
      return random_codes(count, kCodes, 0, random);
  }
}

/// A box whose zeros are positive, as those of primitives are.
rtl::FloatBox any_box(Random& random) {
  rtl::FloatBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto corner = static_cast<IntervalCorner>(random.below(kIntervalCorners));
    const Interval interval = make_interval(corner, random, 6);
    box.lower[axis] = rtl::Float32::of(interval.lower + 0.0F);
    box.upper[axis] = rtl::Float32::of(interval.upper + 0.0F);
  }
  return box;
}

/// Coordinates within two last places of -2 and -1.
rtl::FloatBox neighbouring_box(Random& random) {
  rtl::FloatBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.lower[axis] = rtl::Float32::of_raw(rtl::Float32::of(-2).raw() + random.below(3));
    box.upper[axis] = rtl::Float32::of_raw(rtl::Float32::of(-1).raw() + random.below(3));
  }
  return box;
}

rtl::SceneRegisters any_registers(Random& random) {
  return {rtl::Scale(random.between(-149, 100)), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
}

void add_scene(std::size_t case_class, const rtl::SceneRegisters& registers, Random& random,
               std::vector<EmitStep>& steps) {
  Codes codes = codes_of(case_class, random);
  std::sort(codes.begin(), codes.end());
  for (const std::uint64_t code : codes) {
    EmitStep& step = steps.emplace_back();
    step.item.record = {case_class == kNeighbouringFloats ? neighbouring_box(random) : any_box(random),
                        rtl::UInt<rtl::kMortonBits>(code), rtl::Pointer::of_raw(random.next())};
    step.registers = registers;
  }
  steps.back().item.last_of_run = steps.back().item.last = rtl::UInt<1>(1);
}

enum IdClass : std::size_t {
  kSingleEntry,
  kWholeLines,
  kOneMore,
  kOneLeafOfIds,
  kLeavesOfOne,
  kLargestIds,
  kAnyNumber,
  kSeveralIdScenes
};

std::size_t id_count(std::size_t case_class, Random& random) {
  const std::size_t lines = 1 + random.below(3);
  switch (case_class) {
    case kSingleEntry:
      return 1;
    case kWholeLines:
      return lines * rtl::kWordsPerLine;
    case kOneMore:
      return lines * rtl::kWordsPerLine + 1;
    default:
      return 1 + random.below(50);
  }
}

void add_ids(std::size_t case_class, rtl::LineAddress base, Random& random, std::vector<IdStep>& steps) {
  for (std::size_t left = id_count(case_class, random); left-- > 0;) {
    IdStep step{{rtl::Pointer::of_raw(random.next()), rtl::UInt<1>(random.one_in(3)), rtl::UInt<1>(left == 0)}, base};
    if (case_class == kOneLeafOfIds) step.entry.last_of_leaf = rtl::UInt<1>(0);
    if (case_class == kLeavesOfOne || left == 0) step.entry.last_of_leaf = rtl::UInt<1>(1);
    if (case_class == kLargestIds) step.entry.id = rtl::Pointer((1U << rtl::kPointerBits) - 1 - left);
    steps.push_back(step);
  }
}

enum FloatPairClass : std::size_t {
  kSinglePair,
  kLeftTree,
  kRightTree,
  kBalanced,
  kRandomShape,
  kAnyFloats,
  kLargestPointers,
  kSeveralTrees
};

TreeShape shape_of(std::size_t case_class) {
  switch (case_class) {
    case kSinglePair:
      return TreeShape::single_pair;
    case kLeftTree:
      return TreeShape::left_spine;
    case kRightTree:
      return TreeShape::right_spine;
    case kBalanced:
      return TreeShape::balanced;
    default:
      return TreeShape::random;
  }
}

}  // namespace

std::vector<EmitStep> make_emit_steps(std::size_t case_class, Random& random) {
  std::vector<EmitStep> steps;
  const rtl::SceneRegisters registers = any_registers(random);
  if (case_class != kSeveralScenes) {
    add_scene(case_class, registers, random, steps);
  } else {
    for (int scenes = random.between(2, 4); scenes-- > 0;) {
      add_scene(random.flip() ? kSingleRecord : random.below(kSeveralScenes), registers, random, steps);
    }
  }
  return steps;
}

std::vector<IdStep> make_id_steps(std::size_t case_class, Random& random) {
  std::vector<IdStep> steps;
  const rtl::LineAddress base(random.below(1000));
  for (int scenes = case_class == kSeveralIdScenes ? random.between(2, 4) : 1; scenes-- > 0;) {
    add_ids(case_class == kSeveralIdScenes ? random.below(kSeveralIdScenes) : case_class, base, random, steps);
  }
  return steps;
}

std::vector<rtl::StreamJob> make_float_pairs(std::size_t case_class, Random& random) {
  std::vector<rtl::StreamJob> jobs;
  for (int trees = case_class == kSeveralTrees ? random.between(2, 4) : 1; trees-- > 0;) {
    const auto places = random.flip() ? TreePlaces::halved : TreePlaces::scattered;
    const auto tree = random_tree(shape_of(case_class), places, random.between(1, 4), random).finish({});
    jobs.insert(jobs.end(), tree.begin(), tree.end());
  }
  for (rtl::StreamJob& job : jobs) {
    for (std::size_t child = 0; child < 2; ++child) {
      if (case_class == kLargestPointers) {
        job.pair.pointer[child] = rtl::Pointer((1U << rtl::kPointerBits) - 1 - random.below(8));
      }
      if (case_class != kAnyFloats) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        job.pair.box[child].lower[axis] = rtl::Float32::of(any_finite_float(random));
        job.pair.box[child].upper[axis] = rtl::Float32::of(any_finite_float(random));
      }
    }
  }
  return jobs;
}

}  // namespace cbvh::vectors
