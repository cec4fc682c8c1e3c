// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/kernel/utilisation.h"

#include <algorithm>
#include <utility>

namespace cbvh::rtl {

Utilisation::Utilisation(const Netlist& netlist) {
  const auto names = netlist.modules();
  for (const std::string& name : names) modules_.push_back({{name}});
  const auto number = [&](const std::string& name) {
    return static_cast<std::uint32_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  for (const Netlist::Link& link : netlist.links()) {
    channels_.push_back({link.channel, number(link.producer), number(link.consumer), link.channel->pops(),
                         link.channel->pushes(), link.channel->can_push()});
  }
}

void Utilisation::observe() {
  ++cycles_;
  for (Watched& watched : channels_) {
    const std::uint64_t pops = watched.channel->pops();
    const std::uint64_t pushes = watched.channel->pushes();
    modules_[watched.producer].moved |= pushes != watched.pushes;
    modules_[watched.consumer].moved |= pops != watched.pops;
    modules_[watched.producer].output_full |= !watched.ready;
    watched.pops = pops;
    watched.pushes = pushes;
    watched.ready = watched.channel->can_push();
  }
  for (Module& module : modules_) {
    if (module.moved) {
      ++module.use.busy;
      module.use.stalled_on_input += std::exchange(module.stalled_on_input_since, 0);
      module.use.stalled_on_output += std::exchange(module.stalled_on_output_since, 0);
    } else if (module.output_full) {
      ++module.stalled_on_output_since;
    } else {
      ++module.stalled_on_input_since;
    }
    if (module.use.busy == 0) module.stalled_on_input_since = module.stalled_on_output_since = 0;
    module.moved = module.output_full = false;
  }
}

std::vector<ModuleUse> Utilisation::rows() const {
  std::vector<ModuleUse> rows;
  for (const Module& module : modules_) {
    rows.push_back(module.use);
    rows.back().idle = cycles_ - module.use.busy - module.use.stalled_on_input - module.use.stalled_on_output;
  }
  return rows;
}

}  // namespace cbvh::rtl
