// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "golden/build/lbvh.h"
#include "rtl_model/datapath/lbvh_payloads.h"

/// The golden's hierarchy of sorted records, and what its emission takes.
namespace cbvh::vectors {

struct Emission {
  golden::FloatTree tree;
  /// For each record: how many pairs end with it, being the last of their right subtrees.
  std::vector<std::uint32_t> ends;
  std::uint32_t depth = 0;  ///< the most subtrees that wait for their right sibling at a time
};

/// Throws InputError when the codes are not in order or a coordinate is not finite.
Emission emit(std::span<const rtl::SortRecord> sorted);

}  // namespace cbvh::vectors
