// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/morton.h"
#include "vectors/convert.h"
#include "vectors/generate/morton_jobs.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Boxes to their places on the Morton curve. An episode is one scene: the registers of its first job.
struct MortonEncoder {
  using Stimulus = MortonJob;
  using Response = rtl::SortItem;
  static constexpr std::string_view kName = "morton_encoder";
  static constexpr std::string_view kSummary = "a box to its place on the Morton curve through the scene";
  static constexpr std::string_view kLatencyText = "36";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kMortonClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_morton_jobs(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> jobs, const Parameters&) {
    std::vector<Expected<Response>> items;
    for (const Stimulus& job : jobs) {
      const std::uint32_t code = golden::morton_code(plain_box(job.box.box), plain_box(jobs.front().registers.scene));
      items.push_back({{{job.box.box, rtl::UInt<rtl::kMortonBits>(code), job.box.id}, rtl::UInt<1>(0), job.box.last},
                       static_cast<std::uint32_t>(36 + items.size())});
    }
    return items;
  }
};

}  // namespace cbvh::vectors
