// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "golden/build/float_tree.h"
#include "vectors/faces/line_memory.h"
#include "vectors/faces/refit.h"
#include "vectors/generate/tree_steps.h"
#include "vectors/units/stream_compressor.h"

namespace cbvh::vectors {

/// Gives a compressed tree in memory the boxes of its primitives as they are now. A refused tree has only the report.
template <int N>
struct RefitUnit {
  using Stimulus = RefitStep;
  using Response = TreeEvent<N, rtl::RefitReport>;
  static constexpr std::string_view kName = "refit_unit";
  static constexpr std::string_view kSummary = "a compressed tree in memory around moved primitives";
  static constexpr std::string_view kLatencyText = "1.7 cycles a pair";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = true;
  static constexpr const auto& kClasses = kRefitClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_refit_steps(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters& parameters) {
    const auto commands = commands_of(steps);
    if (commands.size() != 1 || commands[0].pairs.raw() == 0 || commands[0].primitives.raw() == 0) {
      throw golden::InputError("command", "want one, for at least one pair and one primitive");
    }
    const LineMemory memory(steps);
    const WalkAnswer walk =
        walk_tree(topology(memory, commands[0]), primitives(memory, commands[0]), commands[0].registers);
    std::vector<Expected<Response>> events;
    for (const auto& [event, latency] : StreamCompressor<N>::respond(walk.jobs, parameters)) {
      const auto kind = static_cast<typename StreamEvent<N>::Kind>(event.kind.raw());
      if (kind == StreamEvent<N>::Kind::memory) {
        events.push_back({{rtl::UInt<1>(0), event.index, event.pair, {}}, kLatencyNotStated});
      } else if (kind == StreamEvent<N>::Kind::report) {
        events.push_back({{rtl::UInt<1>(1), {}, {}, {event.report, walk.report}}, kLatencyNotStated});
      }
    }
    return events;
  }

 private:
  static std::vector<rtl::TopologyPair> topology(const LineMemory& memory, const rtl::RefitCommand& command) {
    std::vector<rtl::TopologyPair> pairs(command.pairs.raw());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const golden::CompressedPair pair = memory.pair(kRefitPairs, i);
      for (std::size_t c = 0; c < 2; ++c) {
        pairs[i].leaf[c] = rtl::UInt<1>(pair.child[c].leaf);
        pairs[i].pointer[c] = rtl::Pointer(pair.child[c].pointer);
      }
    }
    pairs.back().last = rtl::UInt<1>(1);
    return pairs;
  }

  static std::vector<WalkPrimitive> primitives(const LineMemory& memory, const rtl::RefitCommand& command) {
    std::vector<WalkPrimitive> found;
    for (std::size_t i = 0; i < command.primitives.raw(); ++i) {
      const std::uint32_t entry = memory.word(kRefitIds * 16 + i);
      const std::uint32_t id = entry % golden::kMaxCount;
      WalkPrimitive primitive{{}, (entry & golden::kLastOfLeaf) != 0, id < command.primitives.raw(), true};
      if (primitive.in_range) {
        const std::uint64_t first = kRefitPrimitives * 16 + std::uint64_t{id} * 10;
        for (std::uint64_t v = 0; v < 9; ++v) {
          const float x = rtl::Float32{memory.word(first + v)}.value();
          const auto axis = static_cast<int>(v % 3);
          primitive.finite = primitive.finite && std::isfinite(x);
          primitive.box.lower[axis] = (v < 3 ? x : std::min(primitive.box.lower[axis], x)) + 0.0F;  // -0 + 0 is 0
          primitive.box.upper[axis] = (v < 3 ? x : std::max(primitive.box.upper[axis], x)) + 0.0F;
        }
      }
      found.push_back(primitive);
    }
    return found;
  }
};

}  // namespace cbvh::vectors
