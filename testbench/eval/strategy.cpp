// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/strategy.h"

namespace cbvh::testbench {

namespace {

double per(std::uint64_t bytes, std::uint64_t primitives) {
  return static_cast<double>(bytes) / static_cast<double>(primitives);
}

/// Without backtracks.
golden::Traffic traffic(const Update& update, std::uint64_t primitives, std::uint64_t pairs) {
  return golden::update_traffic(primitives, pairs, 0).*update.traffic;
}

}  // namespace

TrafficParts baseline_parts(const Update& update, std::uint64_t primitives, std::uint64_t pairs) {
  const golden::Traffic ideal = traffic(update, primitives, pairs);
  return {per(ideal.baseline_bytes - ideal.streaming_bytes, primitives), per(ideal.streaming_bytes, primitives), 0};
}

TrafficParts streaming_parts(const Update& update, std::uint64_t primitives, std::uint64_t pairs,
                             std::uint64_t backtracks) {
  const std::uint64_t ideal = traffic(update, primitives, pairs).streaming_bytes;
  const std::uint64_t whole = (golden::update_traffic(primitives, pairs, backtracks).*update.traffic).streaming_bytes;
  return {0, per(ideal, primitives), per(whole - ideal, primitives)};
}

TrafficParts traffic_parts(const Update& update, const Strategy& strategy, const SceneMeasure& scene) {
  if (strategy.counts == nullptr) return baseline_parts(update, scene.triangles, scene.pairs);
  return streaming_parts(update, scene.triangles, scene.pairs,
                         (scene.*strategy.counts).backtracks[strategy.levels - 1]);
}

}  // namespace cbvh::testbench
