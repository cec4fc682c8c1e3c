// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rtl_model/datapath/payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 7> kStackClasses = {
    "random-walk", "fill-to-overflow", "drain-to-underflow", "replace-at-the-top",
    "three-pops",  "post-order",       "single-operation"};
std::vector<rtl::StackOperation> make_stack_operations(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
