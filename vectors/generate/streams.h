// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rtl_model/datapath/payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 23> kStreamClasses = {
    "single-pair",  "deep-left-spine",    "deep-right-spine", "deep-pending",  "balanced",
    "random-shape", "scattered",          "identical-boxes",  "planar",        "points",
    "full-span",    "far-negative",       "coarse-minimum",   "trouble-scene", "procedural-scene",
    "not-finite",   "inverted",           "beyond-exactness", "refused-root",  "too-deep",
    "two-trees",    "refused-then-valid", "small-trees"};

/// The stream of one tree, or of several.
std::vector<rtl::StreamJob> make_stream(std::size_t case_class, Random& random);

/// One valid tree of one of the classes that are neither refused nor several trees.
std::vector<rtl::StreamJob> make_valid_stream(Random& random);
constexpr std::size_t kValidStreamClasses = 15;

}  // namespace cbvh::vectors
