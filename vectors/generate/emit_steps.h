// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/lbvh_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 13> kEmitClasses = {
    "single-record", "one-leaf",  "ends-of-the-curve", "right-spine",       "left-spine",   "part-of-a-spine",
    "full-tree",     "few-codes", "neighbours",        "leaves-of-several", "random-codes", "neighbouring-floats",
    "several-scenes"};
/// Scenes of sorted records.
std::vector<EmitStep> make_emit_steps(std::size_t case_class, Random& random);

inline constexpr std::array<std::string_view, 8> kIdClasses = {
    "single-entry", "whole-lines",   "one-more-than-whole-lines", "one-leaf", "leaves-of-one", "largest-ids",
    "any-number",   "several-scenes"};
/// Primitive-ID arrays.
std::vector<IdStep> make_id_steps(std::size_t case_class, Random& random);

inline constexpr std::array<std::string_view, 8> kFloatPairClasses = {"single-pair",      "left-spine",   "right-spine",
                                                                      "balanced",         "random-shape", "any-floats",
                                                                      "largest-pointers", "several-trees"};
/// Node pairs of trees.
std::vector<rtl::StreamJob> make_float_pairs(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
