// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/pair_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/quantize/quantize.h"
#include "vectors/faces/axis.h"
#include "vectors/generate/floats.h"
#include "vectors/generate/ray_setup_jobs.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kOneCell = 6,
  kHugeBox = 8,
  kFarApart,
  kSubnormalDistance = 11,
  kInfiniteDistance,
  kFullSpan,
  kMinimumScaleSaturation,
  kSameChildren,
  kShortInterval,
  kNotFinite,
  kInverted,
  kScaleBelowMinimum,
  kTooWide,
  kSeveralReasons,
  kAnyCodes,
  kAnyWires
};
constexpr std::size_t kValidTests = kNotFinite;
constexpr int kLeastScale = -256;  // of the wires
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using golden::Cells;

/// A test, the parent's lower index with all its bits, and the children's cells that the codes stand for.
struct Draft {
  PlainPairTest test;
  std::array<Index, 3> parent{};
  std::array<std::array<Cells<Index>, 3>, 2> cells{};
};

int parent_cells(std::size_t case_class, Random& random, int most) {
  if (case_class == kOneCell) return random.between(1, 2);
  if (case_class == kFullSpan || random.one_in(3)) return most;
  return random.between(1, most);
}

/// A child anywhere in its parent.
Cells<Index> child_cells(std::size_t case_class, Index parent, int cells, Random& random) {
  if (case_class == kFullSpan && random.flip()) return {parent, parent + cells};
  const int lower = random.between(0, cells - 1);
  const int upper = case_class == kOneCell || random.one_in(4) ? lower + 1 : random.between(lower + 1, cells);
  return {parent + lower, parent + (random.one_in(4) ? cells : upper)};
}

void make_axis(std::size_t case_class, Draft& draft, std::size_t axis, int scale, Random& random, int bits) {
  const golden::GridRules rules = rules_of(draft.test.registers, bits);
  const int most = static_cast<int>(rules.max_cells());
  const int cells = parent_cells(case_class, random, most);
  Index& parent = draft.parent[axis];
  const int least = -most - (random.flip() ? 0 : 100'000);
  parent = random.between(least, random.flip() ? 0 : 100'000);
  if (case_class == kHugeBox) parent = random.flip() ? -most / 2 : random.between(-most, 0);
  draft.test.node.grid[axis] = {scale, static_cast<int>(golden::modulo(parent, bits)), cells};
  for (auto& child : draft.cells) child[axis] = child_cells(case_class, parent, cells, random);
}

int scale_of(std::size_t case_class, int common, Random& random, int bits) {
  switch (case_class) {
    case kHugeBox:
      return 128 - bits + random.between(0, 1);
    case kFarApart:
      return random.between(-149, 110);
    case kSubnormalDistance:
      return random.between(-149, -130);
    default:
      return common + random.between(-2, 2);
  }
}

rtl::FloatBox parent_box(const Draft& draft) {
  rtl::FloatBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PlainGridAxis& grid = draft.test.node.grid[axis];
    box.lower[axis] = rtl::Float32::of(decoded_edge(draft.parent[axis], grid.scale));
    box.upper[axis] = rtl::Float32::of(decoded_edge(draft.parent[axis] + grid.cells, grid.scale));
  }
  return box;
}

/// A ray at the parent's box, as if it were the root's.
void send_ray(std::size_t case_class, Draft& draft, Random& random) {
  rtl::RaySetupJob job;
  job.root = parent_box(draft);
  aim(case_class < kValidRays - 1 ? case_class : random.below(kValidRays - 1), job, random);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisSetup setup = set_up_axis(job.origin[axis].value(), job.direction[axis].value(),
                                        job.root.lower[axis].value(), job.root.upper[axis].value());
    draft.test.ray[axis] = setup.ray;
    PlainDistances& planes = draft.test.node.planes[axis];
    planes = setup.planes;
    if (case_class == kInfiniteDistance && random.flip()) {
      if (random.flip()) {
        planes.near = -kInfinity;
      } else {
        planes.far = kInfinity;
      }
    }
    if (random.one_in(4)) {  // what rounding on the way down leaves
      planes.near = std::nextafter(planes.near, -kInfinity);
      planes.far = std::nextafter(planes.far, kInfinity);
    }
  }
}

void set_ends(std::size_t case_class, Draft& draft, Random& random) {
  draft.test.t_min = random.flip() ? any_zero(random) : float_within(1, random);
  if (random.flip()) draft.test.t_max = std::fabs(float_within(4, random));
  if (case_class != kShortInterval) return;
  const PlainDistances& planes = draft.test.node.planes[random.below(3)];
  const float end = random.flip() ? planes.near : planes.far;
  (random.flip() ? draft.test.t_min : draft.test.t_max) = end;
  if (random.flip()) draft.test.t_max = draft.test.t_min;
}

void encode_children(Draft& draft, int bits) {
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      draft.test.pair.child[c].codes[axis] =
          golden::encode_codes(draft.cells[c][axis], draft.parent[axis], code_of(draft.test.registers), bits);
    }
  }
}

Draft valid_draft(std::size_t case_class, Random& random, int bits) {
  Draft draft;
  const int common = random.between(-20, 10);
  std::array<int, 3> scales{};
  for (int& scale : scales) scale = scale_of(case_class, common, random, bits);
  const int finest = *std::min_element(scales.begin(), scales.end());
  const int room = case_class == kMinimumScaleSaturation ? random.between(0, 1) : random.between(0, bits + 2);
  const rtl::Scale min_scale(std::max(-149, finest - room));
  const bool figure5 = random.flip();
  draft.test.registers = {min_scale, rtl::UInt<1>(figure5), rtl::UInt<1>(random.flip())};
  for (std::size_t axis = 0; axis < 3; ++axis) make_axis(case_class, draft, axis, scales[axis], random, bits);
  if (case_class == kSameChildren) draft.cells[1] = draft.cells[0];
  if (case_class == kSameChildren && random.flip()) {  // on two axes
    draft.cells[1][0] = child_cells(case_class, draft.parent[0], draft.test.node.grid[0].cells, random);
  }
  for (golden::CompressedChild& child : draft.test.pair.child) {
    child.leaf = random.flip();
    child.pointer = static_cast<std::uint32_t>(random.next() & rtl::low_mask(rtl::kPointerBits));
  }
  send_ray(case_class, draft, random);
  set_ends(case_class, draft, random);
  return draft;
}

void spoil_ray(PlainPairTest& test, Random& random) {
  const std::size_t axis = random.below(3);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  PlainDistances& planes = test.node.planes[axis];
  switch (random.below(6)) {
    case 0:
      test.ray[axis].inverse = any_special_float(random);
      break;
    case 1:
      test.ray[axis].inverse = -test.ray[axis].inverse;
      break;
    case 2:
      planes.near = random.flip() ? kNan : kInfinity;
      break;
    case 3:
      planes.far = random.flip() ? kNan : -kInfinity;
      break;
    case 4:
      test.t_min = kNan;
      break;
    default:
      test.t_max = float_of_bits(0x7F800001 | random.below(2) << 31);
  }
}

/// Spoils one axis of one child, or the ray.
void spoil(Draft& draft, std::size_t reason, Random& random, int bits) {
  const std::size_t axis = random.below(3);
  Cells<Index>& child = draft.cells[random.below(2)][axis];
  PlainGridAxis& grid = draft.test.node.grid[axis];
  const Index parent = draft.parent[axis];
  switch (reason) {
    case kNotFinite:
      spoil_ray(draft.test, random);
      break;
    case kInverted: {
      const int lower = random.between(1, (1 << bits) - 1);
      const int upper = random.flip() ? lower : random.between(1, lower);
      child = {parent + lower, parent + upper};
      break;
    }
    case kScaleBelowMinimum:
      grid.scale = std::max(kLeastScale, static_cast<int>(draft.test.registers.min_scale.value()) - 1 -
                                             (random.flip() ? 0 : random.between(0, 60)));
      break;
    default:  // too wide: one cell beyond the parent, or a whole grid where the rule wants less
      grid.cells = random.between(0, (1 << bits) - 1);
      child = {parent + random.between(0, grid.cells), parent + grid.cells + 1};
      if (random.flip()) {
        draft.test.registers.figure5 = rtl::UInt<1>(1);
        grid.cells = 1 << bits;
        child = {parent, parent + grid.cells};
      }
  }
}

void randomize(PlainPairTest& test, Random& random, int bits) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    test.node.grid[axis] = {static_cast<int>(rtl::Scale::of_raw(random.next()).value()),
                            static_cast<int>(random.below(std::uint64_t{1} << bits)),
                            static_cast<int>(random.below(std::uint64_t{2} << bits))};
    test.node.planes[axis].near = float_of_bits(random.next());
    test.node.planes[axis].far = float_of_bits(random.next());
    test.ray[axis].inverse = random.one_in(8) ? float_of_bits(random.next()) : std::fabs(any_finite_float(random));
    test.ray[axis].backwards = random.flip();
    test.ray[axis].parallel = random.one_in(4);
  }
  test.t_min = float_of_bits(random.next());
  test.t_max = float_of_bits(random.next());
  const rtl::Scale min_scale = rtl::Scale::of_raw(random.next());
  const bool figure5 = random.flip();
  test.registers = {min_scale, rtl::UInt<1>(figure5), rtl::UInt<1>(random.flip())};
  if (random.flip()) test.registers.min_scale = rtl::Scale(kLeastScale);
}

}  // namespace

PlainPairTest make_pair_test(std::size_t case_class, Random& random, int bits) {
  if (case_class < kValidTests) {
    Draft draft = valid_draft(case_class, random, bits);
    encode_children(draft, bits);
    return draft.test;
  }
  Draft draft = valid_draft(random.below(kValidTests), random, bits);
  if (case_class < kSeveralReasons) spoil(draft, case_class, random, bits);
  if (case_class == kSeveralReasons) {
    for (int i = random.between(2, 6); i > 0; --i) spoil(draft, kNotFinite + random.below(4), random, bits);
  }
  encode_children(draft, bits);
  if (case_class == kAnyCodes || (case_class == kAnyWires && random.flip())) {
    for (golden::CompressedChild& child : draft.test.pair.child) {
      for (golden::AxisCodes& codes : child.codes) {
        codes.lower = static_cast<std::uint8_t>(random.below(std::uint64_t{1} << bits));
        codes.upper = static_cast<std::uint8_t>(random.below(std::uint64_t{1} << bits));
      }
    }
  }
  if (case_class == kAnyWires) randomize(draft.test, random, bits);
  return draft.test;
}

PlainPairTest pair_test_at(const golden::CompressedPair& pair, const golden::Context<std::int64_t>& context,
                           const golden::Box& box, const rtl::SceneRegisters& registers, Random& random, int bits) {
  Draft draft;
  draft.test.pair = pair;
  draft.test.registers = registers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<int>(axis);
    const auto cells = golden::encode<Index>(box.lower[a], box.upper[a], context[axis].scale);
    draft.parent[axis] = cells.lower;
    draft.test.node.grid[axis] = {context[axis].scale, static_cast<int>(golden::modulo(cells.lower, bits)),
                                  static_cast<int>(cells.upper - cells.lower)};
  }
  const std::size_t ray = random.below(kFullSpan);
  send_ray(ray, draft, random);
  set_ends(ray, draft, random);
  return draft.test;
}

}  // namespace cbvh::vectors
