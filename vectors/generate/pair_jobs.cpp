// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/pair_jobs.h"

#include <algorithm>
#include <cmath>

#include "golden/quantize/quantize.h"
#include "vectors/faces/pair.h"
#include "vectors/generate/intervals.h"

namespace cbvh::vectors {
namespace {

enum Extra : std::size_t {
  kNotFinite = kIntervalCorners,
  kInverted,
  kBeyondExactness,
  kScaleBelowMinimum,
  kTooWide,
  kSeveralReasons,
  kContextElsewhere,
  kAnyWires
};

float magnitude_of(const Interval& interval) { return std::max(std::fabs(interval.lower), std::fabs(interval.upper)); }

/// A float between the bounds, both included.
float between(const Interval& interval, Random& random) {
  if (random.one_in(6)) return random.flip() ? interval.lower : interval.upper;
  const double lower = static_cast<double>(interval.lower);
  const double upper = static_cast<double>(interval.upper);
  const double x = lower + (upper - lower) * static_cast<double>(random.unit());
  return std::clamp(static_cast<float>(x), interval.lower, interval.upper);
}

/// Two children whose union is the interval.
void split(const Interval& interval, std::size_t axis, Random& random, rtl::FloatPair& pair) {
  const float ends[2][2] = {{interval.lower, between(interval, random)}, {between(interval, random), interval.upper}};
  const std::size_t first = random.below(2);
  const bool nested = random.one_in(5);  // one child spans the axis
  for (std::size_t child = 0; child < 2; ++child) {
    const auto& end = ends[child ^ first];
    const bool whole = nested && child == first;
    pair.box[child].lower[axis] = rtl::Float32::of(whole ? interval.lower : end[0]);
    pair.box[child].upper[axis] = rtl::Float32::of(whole ? interval.upper : end[1]);
  }
}

/// A valid job: boxes, registers, and a context that encloses them.
struct Draft {
  rtl::PairJob job;
  std::array<Interval, 3> axis;
};

void give_context(Draft& draft, Random& random, int bits) {
  const golden::GridRules rules = rules_of(draft.job.registers, bits);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Interval& interval = draft.axis[axis];
    const int gap = random.flip() ? 0 : random.between(0, 3);
    const int scale = std::min(128, golden::enclosing_scale(interval.lower, interval.upper, rules) + gap);
    const Cells<Index> cells = golden::encode<Index>(interval.lower, interval.upper, scale);
    const int room = static_cast<int>(rules.max_cells() - (cells.upper - cells.lower));
    draft.job.context[axis] = to_wires(golden::AxisContext<Index>{scale, cells.lower - random.between(0, room)});
  }
}

Draft valid_draft(std::size_t corner, Random& random, int bits) {
  Draft draft;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t own = random.one_in(4) ? random.below(kIntervalCorners) : corner;
    draft.axis[axis] = make_interval(static_cast<IntervalCorner>(own), random, bits);
  }
  draft.job.registers = draft.axis[random.below(3)].registers;
  for (const Interval& interval : draft.axis) {
    draft.job.registers = allowing(draft.job.registers, magnitude_of(interval));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) split(draft.axis[axis], axis, random, draft.job.pair);
  for (std::size_t child = 0; child < 2; ++child) {
    draft.job.pair.leaf[child] = rtl::UInt<1>(random.flip());
    draft.job.pair.pointer[child] = rtl::Pointer::of_raw(random.one_in(4) ? ~std::uint64_t{0} : random.next());
  }
  draft.job.given_context = rtl::UInt<1>(random.flip());
  give_context(draft, random, bits);
  return draft;
}

Draft any_valid(Random& random, int bits) { return valid_draft(random.below(kIntervalCorners), random, bits); }

/// Spoils one axis of one child.
void spoil(Draft& draft, std::size_t reason, Random& random, int bits) {
  const std::size_t child = random.below(2);
  const std::size_t axis = random.below(3);
  rtl::FloatBox& box = draft.job.pair.box[child];
  Interval interval{box.lower[axis].value(), box.upper[axis].value(), 0, draft.job.registers};
  if (!std::isfinite(interval.lower) || !std::isfinite(interval.upper)) return;  // spoiled before
  switch (reason) {
    case kNotFinite:
      interval = with_special(interval, random);
      break;
    case kInverted:
      interval = inverted(interval, random);
      draft.job.registers = interval.registers;
      break;
    case kBeyondExactness:
      draft.job.registers = too_fine_for(interval, random);
      break;
    case kScaleBelowMinimum:
      draft.job.given_context = rtl::UInt<1>(1);
      draft.job.context[axis].scale = rtl::Scale(draft.job.registers.min_scale.value() - 1 - random.between(0, 3));
      break;
    default: {  // too wide
      draft.job.given_context = rtl::UInt<1>(1);
      interval = make_too_wide(random, bits);
      const auto old_scale = draft.job.registers.min_scale.value();
      if (interval.registers.min_scale.value() > old_scale)
        draft.job.registers.min_scale = interval.registers.min_scale;
      draft.job.context[axis].scale = rtl::Scale(std::max<std::int64_t>(interval.scale, old_scale));
    }
  }
  box.lower[axis] = rtl::Float32::of(interval.lower);
  box.upper[axis] = rtl::Float32::of(interval.upper);
}

/// Too wide on one axis, with a grid that a moderate minimum scale allows everywhere.
Draft too_wide(Random& random, int bits) {
  const std::size_t axis = random.below(3);
  const Interval wide = make_too_wide(random, bits);
  Draft draft = valid_draft(static_cast<std::size_t>(IntervalCorner::signed_zero), random, bits);
  for (std::size_t other = 0; other < 3; ++other) {
    draft.axis[other] = wide;
    split(wide, other, random, draft.job.pair);
  }
  draft.job.registers = wide.registers;
  give_context(draft, random, bits);
  const std::size_t child = random.below(2);
  draft.job.pair.box[child].lower[axis] = rtl::Float32::of(wide.lower);
  draft.job.pair.box[child].upper[axis] = rtl::Float32::of(wide.upper);
  draft.job.context[axis].scale = rtl::Scale(wide.scale);
  draft.job.given_context = rtl::UInt<1>(1);
  return draft;
}

template <class T>
void randomize(T& payload, Random& random) {
  rtl::visit_leaves(payload, [&](auto& leaf) { leaf = std::remove_cvref_t<decltype(leaf)>::of_raw(random.next()); });
}

}  // namespace

rtl::PairJob make_pair_job(std::size_t case_class, Random& random, int bits) {
  if (case_class < kIntervalCorners) return valid_draft(case_class, random, bits).job;
  if (case_class == kTooWide) return too_wide(random, bits).job;
  Draft draft = any_valid(random, bits);
  switch (case_class) {
    case kSeveralReasons:
      for (int i = random.between(2, 6); i > 0; --i) {
        spoil(draft, kNotFinite + random.below(kTooWide - kNotFinite + 1), random, bits);
      }
      break;
    case kContextElsewhere:  // the codes are still cells modulo 2^N
      draft.job.given_context = rtl::UInt<1>(1);
      for (auto& context : draft.job.context) context.lower = rtl::CellIndex::of_raw(random.next());
      break;
    case kAnyWires:
      randomize(draft.job, random);
      break;
    default:
      spoil(draft, case_class, random, bits);
  }
  return draft.job;
}

}  // namespace cbvh::vectors
