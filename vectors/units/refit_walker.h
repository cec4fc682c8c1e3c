// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/input_error.h"
#include "vectors/convert.h"
#include "vectors/faces/refit.h"
#include "vectors/generate/walks.h"
#include "vectors/line_payloads.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// A tree's pairs with new boxes, bottom up, from its topology and its primitives' boxes.
struct RefitWalker {
  using Stimulus = WalkStep;
  using Response = WalkEvent;
  using Kind = WalkStep::Kind;
  static constexpr std::string_view kName = "refit_walker";
  static constexpr std::string_view kSummary = "topology and boxes of primitives to float pairs in emission order";
  static constexpr std::string_view kLatencyText = "1.5 cycles a pair";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kWalkClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    std::vector<Stimulus> steps;
    append(steps, make_walk(case_class, random));
    if (case_class == kTwoWalksClass) append(steps, make_walk(case_class, random));
    return steps;
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    std::vector<PlainWalk> walks = walks_of(steps);
    std::vector<Expected<Response>> events;
    for (const PlainWalk& walk : walks) {
      const WalkAnswer answer = walk_tree(walk.pairs, walk.primitives, walk.registers);
      for (const rtl::StreamJob& job : answer.jobs) events.push_back({{rtl::UInt<1>(0), job, {}}, kLatencyNotStated});
      events.push_back({{rtl::UInt<1>(1), {}, answer.report}, kLatencyNotStated});
    }
    return events;
  }

 private:
  static rtl::UInt<2> kind(Kind kind) { return rtl::UInt<2>(static_cast<std::uint64_t>(kind)); }

  static void append(std::vector<Stimulus>& steps, const PlainWalk& walk) {
    steps.push_back({kind(Kind::start), walk.registers, {}, {}, {}});
    for (const rtl::TopologyPair& pair : walk.pairs) steps.push_back({kind(Kind::pair), {}, pair, {}, {}});
    for (std::size_t i = 0; i < walk.primitives.size(); ++i) {
      const WalkPrimitive& primitive = walk.primitives[i];
      const rtl::UInt<1> last(i + 1 == walk.primitives.size());
      const auto status = primitive.finite ? rtl::Status::ok : rtl::Status::not_finite;
      steps.push_back({kind(Kind::primitive),
                       {},
                       {},
                       {float_box(primitive.box), {}, last, rtl::StatusBits(static_cast<std::uint64_t>(status))},
                       {rtl::UInt<1>(primitive.last_of_leaf), last, rtl::UInt<1>(primitive.in_range)}});
    }
  }

  /// Each kind's items belong to the trees in turn.
  static std::vector<PlainWalk> walks_of(std::span<const Stimulus> steps) {
    std::vector<PlainWalk> walks;
    for (const Stimulus& step : steps) {
      if (step.kind == kind(Kind::start)) walks.push_back({{}, {}, step.registers});
    }
    std::size_t pairs_end = 0;
    std::size_t primitives_end = 0;
    for (const Stimulus& step : steps) {
      if (step.kind == kind(Kind::pair)) {
        at(walks, pairs_end).pairs.push_back(step.pair);
        pairs_end += step.pair.last.raw();
      } else if (step.kind == kind(Kind::primitive)) {
        WalkPrimitive primitive{{}, bool(step.mark.last_of_leaf), bool(step.mark.in_range), true};
        primitive.finite = step.primitive.status.raw() == 0;
        for (int axis = 0; axis < 3; ++axis) {
          primitive.box.lower[axis] = step.primitive.box.lower[static_cast<std::size_t>(axis)].value();
          primitive.box.upper[axis] = step.primitive.box.upper[static_cast<std::size_t>(axis)].value();
        }
        at(walks, primitives_end).primitives.push_back(primitive);
        primitives_end += step.mark.last.raw();
      }
    }
    if (pairs_end != walks.size() || primitives_end != walks.size()) {
      throw golden::InputError("last", "a tree whose pairs or primitives do not end");
    }
    return walks;
  }
  static PlainWalk& at(std::vector<PlainWalk>& walks, std::size_t index) {
    if (index >= walks.size()) throw golden::InputError("kind", "more trees than starts");
    return walks[index];
  }
};

}  // namespace cbvh::vectors
