// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/kernel/netlist.h"

#include <algorithm>

namespace cbvh::rtl {

std::vector<std::string> Netlist::modules() const {
  std::vector<std::string> names;
  const auto add_name = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Link& link : links_) {
    add_name(link.producer);
    add_name(link.consumer);
  }
  return names;
}

std::uint64_t Netlist::transfers() const {
  std::uint64_t sum = 0;
  for (const Link& link : links_) sum += link.channel->pops();
  return sum;
}

std::vector<std::string> Netlist::waiting() const {
  std::vector<std::string> reasons;
  for (const Link& link : links_) {
    const std::string passed = std::to_string(link.channel->pops()) + " so far";
    if (link.channel->can_pop()) {
      reasons.push_back(link.producer + " waits for " + link.consumer + " to take " + link.name + " (" + passed + ")");
    } else if (link.ended && !link.ended()) {
      reasons.push_back(link.consumer + " waits for " + link.name + " from " + link.producer + " (" + passed + ")");
    }
  }
  return reasons;
}

}  // namespace cbvh::rtl
