// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "vectors/convert.h"
#include "vectors/faces/emission.h"
#include "vectors/generate/emit_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Sorted records to node pairs in emission order and the primitive-ID array, scene after scene.
struct HierarchyEmitter {
  using Stimulus = EmitStep;
  using Response = EmitEvent;
  using Kind = EmitEvent::Kind;
  static constexpr std::string_view kName = "hierarchy_emitter";
  static constexpr std::string_view kSummary = "sorted records to node pairs in emission order, and primitive IDs";
  static constexpr std::string_view kLatencyText = "1 a pair, or a record that ends none";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kEmitClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_emit_steps(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    std::vector<Expected<Response>> events;
    std::uint32_t cycle = 0;  // in which the scene's first record is taken
    while (!steps.empty()) {
      std::vector<rtl::SortRecord> scene;
      do {
        if (scene.size() == steps.size()) throw golden::InputError("last", "not set in the last record");
        scene.push_back(steps[scene.size()].item.record);
      } while (!steps[scene.size() - 1].item.last);
      cycle = respond_scene(emit(scene), steps.front().registers, cycle, events);
      steps = steps.subspan(scene.size());
    }
    return events;
  }

 private:
  /// A record is taken in the cycle in which the last of the pairs that end before it is sent, or in the next one if
  /// there are none; the ID of the one before is sent then. What is sent is seen a cycle later.
  static std::uint32_t respond_scene(const Emission& emission, const rtl::SceneRegisters& registers,
                                     std::uint32_t cycle, std::vector<Expected<Response>>& events) {
    const golden::FloatTree& tree = emission.tree;
    std::vector<std::uint32_t> id_cycles;
    std::size_t pair = 0;
    for (std::size_t i = 0; i < emission.ends.size(); ++i) {
      const bool last = i + 1 == emission.ends.size();
      for (std::uint32_t ended = 1; ended <= emission.ends[i]; ++ended) {
        Response event = of_kind(Kind::pair);
        event.job = stream_job(tree, pair++, registers);
        events.push_back({event, cycle + ended + 1});
      }
      id_cycles.push_back(cycle + 1 + (last ? 1 : std::max(emission.ends[i], 1U)));
      cycle += std::max(emission.ends[i], 1U);
    }
    for (std::size_t i = 0; i < id_cycles.size(); ++i) {
      const std::uint32_t entry = tree.primitive_ids[i];
      Response event = of_kind(Kind::id);
      event.id = {rtl::Pointer(entry & ~golden::kLastOfLeaf), rtl::UInt<1>((entry & golden::kLastOfLeaf) != 0),
                  rtl::UInt<1>(i + 1 == id_cycles.size())};
      events.push_back({event, id_cycles[i]});
    }
    Response event = of_kind(Kind::report);
    event.report = {rtl::UInt<rtl::kPointerBits + 1>(tree.pairs.size()), rtl::UInt<rtl::kPointerBits + 1>(tree.leaves),
                    rtl::UInt<rtl::kPointerBits + 1>(tree.primitives), float_box(tree.scene),
                    rtl::UInt<5>(emission.depth)};
    events.push_back({event, cycle + 2});
    return cycle + 2;
  }
  static Response of_kind(Kind kind) {
    Response event;
    event.kind = rtl::UInt<2>(static_cast<std::uint64_t>(kind));
    return event;
  }
};

}  // namespace cbvh::vectors
