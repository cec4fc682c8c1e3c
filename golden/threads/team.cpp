// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/threads/team.h"

#include <thread>
#include <vector>

namespace cbvh::golden {

void run_team(unsigned threads, const std::function<void(const TeamMember&)>& work) {
  std::barrier<> barrier(threads);
  const auto run = [&](unsigned index) noexcept { work(TeamMember(index, threads, barrier)); };
  std::vector<std::jthread> others;
  for (unsigned index = 1; index < threads; ++index) others.emplace_back(run, index);
  run(0);
}

}  // namespace cbvh::golden
