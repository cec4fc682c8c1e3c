// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/decode_jobs.h"

#include <algorithm>
#include <cmath>

#include "golden/quantize/quantize.h"
#include "vectors/faces/box_decode.h"
#include "vectors/generate/intervals.h"

namespace cbvh::vectors {
namespace {

enum Extra : std::size_t {
  kParentsUpperEdge = kIntervalCorners,
  kLargestIndex,
  kInverted,
  kBeyondExactness,
  kScaleBelowMinimum,
  kTooWide,
  kSeveralReasons,
  kAnyCodes,
  kAnyWires
};

constexpr int kLeastScale = -256;  // of the wires

/// A job, and the cells that its codes stand for.
struct Draft {
  PlainDecodeJob job;
  std::array<Cells<Index>, 3> cells{};
};

Index capacity(int bits) { return Index{1} << bits; }

/// A child anywhere within its parent or, for equation 9, at the parent's upper edge.
Draft valid_draft(std::size_t corner, bool at_upper_edge, Random& random, int bits) {
  Draft draft;
  std::array<Interval, 3> axes;
  for (Interval& interval : axes) {
    const std::size_t own = random.one_in(4) ? random.below(kIntervalCorners) : corner;
    interval = make_interval(static_cast<IntervalCorner>(own), random, bits);
  }
  draft.job.registers = axes[random.below(3)].registers;
  for (const Interval& interval : axes) {
    draft.job.registers = allowing(draft.job.registers, std::max(std::fabs(interval.lower), std::fabs(interval.upper)));
  }
  const golden::GridRules rules = rules_of(draft.job.registers, bits);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Interval& interval = axes[axis];
    const int gap = at_upper_edge ? 1 : random.flip() ? 0 : random.between(0, 3);
    const int scale = std::min(128, golden::enclosing_scale(interval.lower, interval.upper, rules) + gap);
    draft.cells[axis] = golden::encode<Index>(interval.lower, interval.upper, scale);
    const Index room = capacity(bits) - (draft.cells[axis].upper - draft.cells[axis].lower);
    const Index before = at_upper_edge ? room : random.between(0, static_cast<int>(room));
    draft.job.parent[axis] = {scale, draft.cells[axis].lower - before};
  }
  draft.job.node.leaf = random.flip();
  draft.job.node.pointer = static_cast<std::uint32_t>((random.one_in(4) ? ~std::uint64_t{0} : random.next()) &
                                                      rtl::low_mask(rtl::kPointerBits));
  return draft;
}

Draft any_valid(Random& random, int bits) { return valid_draft(random.below(kIntervalCorners), false, random, bits); }

/// The cells `lower` to `upper` of the parent.
void place(Draft& draft, std::size_t axis, Index lower, Index upper) {
  const Index parent = draft.job.parent[axis].lower;
  draft.cells[axis] = {parent + lower, parent + upper};
}

void make_inexact(Draft& draft, std::size_t axis, Random& random, int bits) {
  const Index sign = random.flip() ? 1 : -1;
  golden::AxisContext<Index>& parent = draft.job.parent[axis];
  switch (random.below(4)) {
    case 0:  // finer than any float
      draft.job.registers.min_scale = rtl::Scale(-150 - (random.flip() ? 0 : random.between(0, -150 - kLeastScale)));
      break;
    case 1:  // an edge anywhere outside
      parent.lower = sign * random.between((1 << 24) + (1 << bits) + 1, (1 << 25) - 1);
      place(draft, axis, random.between(0, (1 << bits) - 1), capacity(bits));
      break;
    case 2:  // the last edge of the child alone, by one
      parent.lower = sign > 0 ? kLargestExactIndex + 1 - capacity(bits) : -kLargestExactIndex - 1;
      place(draft, axis, 0, capacity(bits));
      break;
    default:  // the own lower index alone
      parent.lower = sign * (kLargestExactIndex - capacity(bits) - random.between(0, 1 << 22));
      parent.scale = static_cast<int>(draft.job.registers.min_scale.value()) + random.between(1, 9);
      place(draft, axis, 0, 1);
  }
}

/// One cell of one axis, the last before its own lower index or an edge would be beyond exactness.
void make_largest(Draft& draft, Random& random, int bits) {
  const std::size_t axis = random.below(3);
  const int finer = random.between(0, bits - 1);
  golden::AxisContext<Index>& parent = draft.job.parent[axis];
  parent.scale = static_cast<int>(draft.job.registers.min_scale.value()) + finer;
  parent.lower = kLargestExactIndex >> static_cast<unsigned>(finer);
  if (random.flip()) {
    parent.lower = -parent.lower;
  } else if (finer == 0) {
    --parent.lower;
  }
  place(draft, axis, 0, 1);
}

/// Spoils one axis.
void spoil(Draft& draft, std::size_t reason, Random& random, int bits) {
  const std::size_t axis = random.below(3);
  golden::AxisContext<Index>& parent = draft.job.parent[axis];
  switch (reason) {
    case kInverted: {
      const int lower = random.between(1, (1 << bits) - 1);
      place(draft, axis, lower, random.flip() ? lower : random.between(1, lower));
      break;
    }
    case kBeyondExactness:
      make_inexact(draft, axis, random, bits);
      break;
    case kScaleBelowMinimum: {
      const int below = random.flip() ? 1 : random.between(1, 60);
      parent.scale = std::max(kLeastScale, static_cast<int>(draft.job.registers.min_scale.value()) - below);
      break;
    }
    default:  // too wide
      draft.job.registers.figure5 = rtl::UInt<1>(1);
      parent.lower = std::clamp(parent.lower, -kLargestExactIndex, kLargestExactIndex - capacity(bits));
      place(draft, axis, 0, capacity(bits));
  }
}

PlainDecodeJob finish(Draft draft, int bits) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    draft.job.node.codes[axis] =
        golden::encode_codes(draft.cells[axis], draft.job.parent[axis].lower, code_of(draft.job.registers), bits);
  }
  return draft.job;
}

void randomize_codes(PlainDecodeJob& job, Random& random, int bits) {
  for (golden::AxisCodes& codes : job.node.codes) {
    codes.lower = static_cast<std::uint8_t>(random.below(std::uint64_t{1} << bits));
    codes.upper = static_cast<std::uint8_t>(random.below(std::uint64_t{1} << bits));
  }
}

}  // namespace

PlainDecodeJob make_decode_job(std::size_t case_class, Random& random, int bits) {
  if (case_class < kIntervalCorners) return finish(valid_draft(case_class, false, random, bits), bits);
  if (case_class == kParentsUpperEdge) {
    return finish(valid_draft(random.below(kIntervalCorners), true, random, bits), bits);
  }
  Draft draft = any_valid(random, bits);
  if (case_class == kLargestIndex) make_largest(draft, random, bits);
  if (case_class == kSeveralReasons) {
    for (int i = random.between(2, 6); i > 0; --i) {
      spoil(draft, kInverted + random.below(kTooWide - kInverted + 1), random, bits);
    }
    return finish(draft, bits);
  }
  if (case_class < kSeveralReasons) {
    if (case_class != kLargestIndex) spoil(draft, case_class, random, bits);
    return finish(draft, bits);
  }
  PlainDecodeJob job = finish(draft, bits);
  randomize_codes(job, random, bits);
  if (case_class == kAnyWires) {
    for (golden::AxisContext<Index>& axis : job.parent) {
      axis.scale = static_cast<int>(rtl::Scale::of_raw(random.next()).value());
      axis.lower = rtl::CellIndex::of_raw(random.next()).value();
    }
    const rtl::Scale min_scale = rtl::Scale::of_raw(random.next());
    const bool figure5 = random.flip();
    job.registers = {min_scale, rtl::UInt<1>(figure5), rtl::UInt<1>(random.flip())};
  }
  return job;
}

}  // namespace cbvh::vectors
