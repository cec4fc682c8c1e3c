// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cbvh::vectors {

using rtl::Status;

golden::GridRules rules_of(const rtl::SceneRegisters& registers, int bits) {
  return {bits, static_cast<int>(registers.min_scale.value()),
          registers.figure5.raw() != 0 ? golden::ScaleRule::figure5 : golden::ScaleRule::equation2};
}

Status interval_status(float lower, float upper, const rtl::SceneRegisters& registers) {
  if (!std::isfinite(lower) || !std::isfinite(upper)) return Status::not_finite;
  if (lower > upper) return Status::inverted;
  const float largest = std::max(std::fabs(lower), std::fabs(upper));
  if (registers.min_scale.value() < golden::exactness_limit(largest)) return Status::beyond_exactness;
  return Status::ok;
}

AxisAnswer compress_axis(float lower, float upper, int scale, const rtl::SceneRegisters& registers, int bits) {
  const golden::GridRules rules = rules_of(registers, bits);
  AxisAnswer answer;
  answer.status = interval_status(lower, upper, registers);
  if (answer.status != Status::ok) return answer;
  if (scale < rules.min_scale) {
    answer.status = Status::scale_below_minimum;
    return answer;
  }
  answer.cells = golden::encode<Index>(lower, upper, scale);
  if (answer.cells.upper - answer.cells.lower > rules.max_cells()) {
    answer.status = Status::too_wide;
    return answer;
  }
  answer.own = golden::own_context(answer.cells, scale, rules);
  return answer;
}

float decoded_edge(Index index, int scale) {
  const double exact = static_cast<double>(index) * golden::power_of_two(scale);  // 26 bits: a double
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (exact >= 0x1p128) return kInfinity;
  if (exact <= -0x1p128) return -kInfinity;
  return golden::edge(index, scale);
}

golden::Context<Index> from_wires(const rtl::Context& context) {
  return {from_wires(context[0]), from_wires(context[1]), from_wires(context[2])};
}

rtl::Context to_wires(const golden::Context<Index>& context) {
  return {to_wires(context[0]), to_wires(context[1]), to_wires(context[2])};
}

}  // namespace cbvh::vectors
