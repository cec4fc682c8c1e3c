// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "golden/quantize/quantize.h"
#include "golden/trace/plane_distance.h"
#include "rtl_model/datapath/intersect_pair.h"
#include "rtl_model/datapath/ray_setup.h"
#include "vectors/generate/ray_setup_jobs.h"
#include "vectors/random.h"

/// Rays down random nested boxes through the pair intersector's datapath, every plane distance judged without rounding.
namespace cbvh::testing {

/// Of all box tests.
struct WalkedBoxes {
  std::uint64_t tests = 0;
  std::uint64_t violations = 0;  ///< with a distance on the wrong side of the exact one
  std::uint64_t hits = 0;
  std::uint64_t refused = 0;
};

template <int N>
class RayWalk {
 public:
  /// A ray of one of vectors::kValidRays classes, but not at infinite edges, at a root anywhere.
  RayWalk(std::size_t case_class, vectors::Random& random) : random_(random) {
    const int common = random.between(-60, 60);
    job_.registers.min_scale = rtl::Scale(common - 30);
    job_.registers.relative = rtl::UInt<1>(random.flip());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int scale = common + random.between(0, 3);
      lower_[axis] = random.between(-3000, 3000);
      const auto cells = static_cast<std::uint64_t>(random.between(1, 1 << N));
      job_.node.grid[axis] = {rtl::Scale(scale), rtl::UInt<N>::of_raw(static_cast<std::uint64_t>(lower_[axis])),
                              rtl::UInt<N + 1>(cells)};
      setup_.root.lower[axis] = rtl::Float32::of(golden::edge(lower_[axis], scale));
      setup_.root.upper[axis] = rtl::Float32::of(golden::edge(lower_[axis] + static_cast<std::int64_t>(cells), scale));
    }
    vectors::aim(case_class, setup_, random);
    const rtl::RaySetupResult ready = rtl::ray_setup<rtl::MachineBits>(setup_);
    job_.ray = ready.ray;
    job_.node.planes = ready.planes;
    job_.t_max = rtl::Float32{0x7F800000};
  }

  /// Two random children, and down to one of them; false if the ray hits neither.
  bool step(WalkedBoxes& walked) {
    std::array<std::array<golden::Cells<std::int64_t>, 3>, 2> cells;
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t axis = 0; axis < 3; ++axis) cells[c][axis] = add_child(job_.pair.child[c], axis);
    }
    const rtl::PairTestResult<N> result = rtl::intersect_pair<rtl::MachineBits, N>(job_);
    walked.refused += result.status != rtl::StatusBits();
    for (std::size_t c = 0; c < 2; ++c) judge(result.child[c], cells[c], walked);
    const std::size_t next = result.child[1].hit ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto finer = job_.node.grid[axis].scale.value() - result.child[next].node.grid[axis].scale.value();
      lower_[axis] = cells[next][axis].lower * (std::int64_t{1} << finer);
    }
    job_.node = result.child[next].node;
    return bool(result.child[next].hit);
  }

 private:
  golden::Cells<std::int64_t> add_child(rtl::NodeCodes<N>& codes, std::size_t axis) {
    const int most = static_cast<int>(job_.node.grid[axis].cells.value());
    const int margin = random_.one_in(4) ? most - 1 : most / 4;
    const int from = random_.between(0, margin);
    const int to = std::max(from + 1, most - random_.between(0, margin));
    const auto origin = job_.registers.relative ? 0 : static_cast<int>(job_.node.grid[axis].lower.value());
    codes.lo[axis] = rtl::UInt<N>::of_raw(static_cast<std::uint64_t>(origin + from));
    codes.hi[axis] = rtl::UInt<N>::of_raw(static_cast<std::uint64_t>(origin + to));
    return {lower_[axis] + from, lower_[axis] + to};
  }

  void judge(const rtl::TestedChild<N>& child, const std::array<golden::Cells<std::int64_t>, 3>& cells,
             WalkedBoxes& walked) {
    bool encloses = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double cell = golden::power_of_two(static_cast<int>(job_.node.grid[axis].scale.value()));
      const double lower = static_cast<double>(cells[axis].lower) * cell;
      const double upper = static_cast<double>(cells[axis].upper) * cell;
      const float near = child.node.planes[axis].near.value();
      const float far = child.node.planes[axis].far.value();
      const float origin = setup_.origin[axis].value();
      const float direction = setup_.direction[axis].value();
      if (direction == 0) {
        encloses = encloses && golden::at_or_before(near, lower, static_cast<double>(origin), 1) &&
                   golden::at_or_before(-far, -upper, -static_cast<double>(origin), 1);
      } else {
        encloses = encloses && golden::not_after_plane(near, direction < 0 ? upper : lower, origin, direction) &&
                   golden::not_before_plane(far, direction < 0 ? lower : upper, origin, direction);
      }
    }
    ++walked.tests;
    walked.violations += !encloses;
    walked.hits += child.hit.value();
  }

  vectors::Random& random_;
  rtl::RaySetupJob setup_;
  rtl::PairTestJob<N> job_;
  std::array<std::int64_t, 3> lower_{};
};

/// At least so many box tests of N bits.
template <int N>
WalkedBoxes walk_rays(std::uint64_t tests, std::uint64_t seed) {
  constexpr int kLevels = 12;
  vectors::Random random(seed);
  WalkedBoxes walked;
  for (std::size_t i = 0; walked.tests < tests; ++i) {
    RayWalk<N> walk(i % (vectors::kValidRays - 1), random);
    const bool to_the_end = random.one_in(8);
    for (int level = 0; level < kLevels; ++level) {
      if (!walk.step(walked) && !to_the_end) break;
    }
  }
  return walked;
}

}  // namespace cbvh::testing
