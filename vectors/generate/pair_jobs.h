// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "rtl_model/datapath/payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 20> kPairJobClasses = {"signed-zero",       "subnormal",
                                                                     "largest-finite",    "sign-crossing",
                                                                     "edge-on-grid",      "one-cell",
                                                                     "power-of-two-size", "full-grid",
                                                                     "degenerate-axis",   "minimum-scale-saturation",
                                                                     "exponent-gap",      "random-bits",
                                                                     "not-finite",        "inverted",
                                                                     "beyond-exactness",  "scale-below-minimum",
                                                                     "too-wide",          "several-reasons",
                                                                     "context-elsewhere", "any-wires"};
rtl::PairJob make_pair_job(std::size_t case_class, Random& random, int bits);

}  // namespace cbvh::vectors
