// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/tree/float_pair_format.h"
#include "vectors/faces/writing.h"
#include "vectors/generate/emit_steps.h"

namespace cbvh::vectors {

/// Where the pairs of a case lie.
constexpr rtl::LineAddress kFloatPairBase{3};

/// Node pairs to memory as they are, in binary32.
struct FloatNodeWriter {
  using Stimulus = rtl::StreamJob;
  using Response = WriteEvent;
  static constexpr std::string_view kName = "float_node_writer";
  static constexpr std::string_view kSummary = "writes node pairs to memory in binary32, a line each";
  static constexpr std::string_view kLatencyText = "1 a pair, 6 at the end";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kFloatPairClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_float_pairs(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> jobs, const Parameters&) {
    if (jobs.empty() || !jobs.back().root) throw golden::InputError("root", "not set in the last pair");
    WriteEvents writer(kFloatPairBase.value());
    for (const Stimulus& job : jobs) {
      rtl::LineWords words;
      const golden::FloatPairWords packed = golden::pack_float_pair(from_wires(job.pair));
      for (std::size_t i = 0; i < packed.size(); ++i) words[i] = rtl::UInt<32>(packed[i]);
      writer.write(words, 0xFFFF, bool(job.root));
    }
    return writer.events;
  }

 private:
  static golden::FloatPair from_wires(const rtl::FloatPair& wires) {
    golden::FloatPair pair{};
    for (std::size_t child = 0; child < 2; ++child) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto component = static_cast<std::size_t>(axis);
        pair.child[child].lower[axis] = wires.box[child].lower[component].value();
        pair.child[child].upper[axis] = wires.box[child].upper[component].value();
      }
      pair.leaf[child] = bool(wires.leaf[child]);
      pair.pointer[child] = static_cast<std::uint32_t>(wires.pointer[child].value());
    }
    return pair;
  }
};

}  // namespace cbvh::vectors
