// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/quantize/quantize.h"
#include "vectors/payloads.h"

/// The golden's answer for one axis, in plain numbers.
namespace cbvh::vectors {

using golden::Cells;
using Index = std::int64_t;

golden::GridRules rules_of(const rtl::SceneRegisters& registers, int bits);
inline golden::Code code_of(const rtl::SceneRegisters& registers) {
  return registers.relative.raw() != 0 ? golden::Code::relative : golden::Code::modulo;
}

/// What refuses an interval whatever its grid: not_finite, inverted, beyond_exactness, or ok.
rtl::Status interval_status(float lower, float upper, const rtl::SceneRegisters& registers);

struct AxisAnswer {
  rtl::Status status = rtl::Status::ok;
  Cells<Index> cells{};              ///< on the grid of the job; this and what follows is valid when the status is ok
  golden::AxisContext<Index> own{};  ///< rule 4
};

/// The interval on the grid 2^scale.
AxisAnswer compress_axis(float lower, float upper, int scale, const rtl::SceneRegisters& registers, int bits);

/// index * 2^scale as a binary32: +-infinity at or beyond 2^128, +0 for 0.
float decoded_edge(Index index, int scale);

inline golden::AxisContext<Index> from_wires(const rtl::AxisContext& context) {
  return {static_cast<int>(context.scale.value()), context.lower.value()};
}
inline rtl::AxisContext to_wires(const golden::AxisContext<Index>& context) {
  return {rtl::Scale(context.scale), rtl::CellIndex(context.lower)};
}
golden::Context<Index> from_wires(const rtl::Context& context);
rtl::Context to_wires(const golden::Context<Index>& context);

}  // namespace cbvh::vectors
