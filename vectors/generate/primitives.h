// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/lbvh_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 9> kPrimitiveClasses = {
    "scene-like",  "signed-zero", "subnormal",  "largest-finite", "degenerate-axis",
    "three-equal", "random-bits", "not-finite", "any-wires"};
rtl::Primitive make_primitive(std::size_t case_class, Random& random);

inline constexpr std::array<std::string_view, 5> kPrimitiveLineClasses = {"single-primitive", "across-a-line",
                                                                          "whole-lines", "any-number", "many"};
/// The lines that hold a number of primitives; what follows the last one is not zero.
std::vector<PrimitiveLine> make_primitive_lines(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
