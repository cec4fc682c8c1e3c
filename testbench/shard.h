// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "vectors/vector_set.h"

namespace cbvh::testbench {

/// A share of a numbered set of cases. Shares are disjoint and cover all.
using vectors::Shard;

inline bool owns(const Shard& shard, std::uint64_t number) { return number % shard.count == shard.index; }
inline bool is_whole(const Shard& shard) { return shard.count == 1; }

/// "i/n" with 0 <= i <= n: n stands for 0, so that job arrays may count from 0 or from 1. Throws InputError.
Shard parse_shard(const std::string& text);
std::string to_string(const Shard& shard);

}  // namespace cbvh::testbench
