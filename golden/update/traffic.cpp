// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/traffic.h"

namespace cbvh::golden {

UpdateTraffic update_traffic(std::uint64_t primitives, std::uint64_t pairs, std::uint64_t backtracks) {
  constexpr std::uint64_t kPrimitive = 40;
  constexpr std::uint64_t kSorting = 64;
  constexpr std::uint64_t kId = 4;
  constexpr std::uint64_t kPair = 16;
  constexpr std::uint64_t kFloatPair = 64;
  constexpr std::uint64_t kAccess = 64;
  const std::uint64_t backtracking = backtracks * (kAccess + kAccess);
  const std::uint64_t top_down_pass = pairs * (kFloatPair + kFloatPair);
  const std::uint64_t lbvh = primitives * (kPrimitive + kSorting + kId) + pairs * kPair;
  const std::uint64_t refit = primitives * (kId + kPrimitive) + pairs * (kPair + kPair);
  return {{lbvh + top_down_pass, lbvh + backtracking}, {refit + top_down_pass, refit + backtracking}};
}

}  // namespace cbvh::golden
