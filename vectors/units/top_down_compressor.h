// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>

#include "golden/build/float_tree.h"
#include "vectors/faces/line_memory.h"
#include "vectors/faces/pair.h"
#include "vectors/generate/tree_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Compresses a float tree in memory from the root down. A refused tree has only the report.
template <int N>
struct TopDownCompressor {
  using Stimulus = TopDownStep;
  using Response = TreeEvent<N, rtl::StreamReport>;
  static constexpr std::string_view kName = "top_down_compressor";
  static constexpr std::string_view kSummary = "a float tree in memory to a compressed one, top down";
  static constexpr std::string_view kLatencyText = "1.2 cycles a pair, 7 on a spine";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kTopDownClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_top_down_steps(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    const auto commands = commands_of(steps);
    if (commands.size() != 1 || commands[0].pairs.raw() == 0) {
      throw golden::InputError("command", "want one, for at least one pair");
    }
    const LineMemory memory(steps);
    std::vector<Expected<Response>> events;
    std::map<std::uint64_t, rtl::NodePair<N>> pairs;
    const rtl::StreamReport report = compress(memory, commands[0], pairs);
    if (report.status.raw() == 0) {
      for (const auto& [index, pair] : pairs) {
        events.push_back({{rtl::UInt<1>(0), rtl::Pointer(index), pair, {}}, kLatencyNotStated});
      }
    }
    events.push_back({{rtl::UInt<1>(1), {}, {}, report}, kLatencyNotStated});
    return events;
  }

 private:
  struct Announced {
    std::uint64_t index;
    std::optional<golden::Context<Index>> context;  ///< the root has its own
  };

  /// Every pair must be announced by its parent, which comes right before it or before its sibling's subtree.
  static rtl::StreamReport compress(const LineMemory& memory, const rtl::TopDownCommand& command,
                                    std::map<std::uint64_t, rtl::NodePair<N>>& pairs) {
    const std::uint64_t count = command.pairs.raw();
    std::vector<Announced> announced{{count - 1, {}}};
    rtl::StreamReport report;
    report.last_index = rtl::Pointer(count - 1);
    for (std::uint64_t index = count; index-- > 0;) {
      if (announced.empty() || announced.back().index != index) return refused(rtl::Status::underflow, index);
      const rtl::FloatPair pair = float_pair_in(memory, index);
      const PairAnswer answer = compress_pair(pair, announced.back().context, command.registers, N);
      if (answer.status != rtl::Status::ok) return refused(answer.status, index);
      announced.pop_back();
      pairs[index] = to_wires<N>(stored_pair(pair, answer, command.registers, N));
      if (index + 1 == count) report.root = to_wires(answer.context);
      for (std::size_t c = 0; c < 2; ++c) {
        if (pair.leaf[c]) continue;
        const std::uint64_t below = pair.pointer[c].raw();
        const bool in_order = below < index && (announced.empty() || below > announced.back().index);
        if (!in_order) return refused(rtl::Status::underflow, index);
        if (announced.size() == rtl::kContextStackDepth) return refused(rtl::Status::overflow, index);
        announced.push_back({below, answer.child_context[c]});
      }
    }
    return report;
  }

  static rtl::FloatPair float_pair_in(const LineMemory& memory, std::uint64_t index) {
    rtl::FloatPair pair;
    for (std::size_t c = 0; c < 2; ++c) {
      const std::uint64_t first = (kTopDownFloatPairs + index) * 16 + c * 8;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        pair.box[c].lower[axis] = {memory.word(first + axis)};
        pair.box[c].upper[axis] = {memory.word(first + 3 + axis)};
      }
      const std::uint32_t word = memory.word(first + 6);
      pair.leaf[c] = rtl::UInt<1>(word >> 31);
      pair.pointer[c] = rtl::Pointer(word % golden::kMaxCount);
    }
    return pair;
  }

  static rtl::StreamReport refused(rtl::Status status, std::uint64_t index) {
    return {rtl::Pointer(index), {}, {}, rtl::StatusBits(static_cast<std::uint64_t>(status))};
  }
};

}  // namespace cbvh::vectors
