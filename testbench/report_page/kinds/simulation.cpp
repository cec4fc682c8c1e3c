// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "testbench/report_page/kinds/machine.h"

/// `cbvh sim`: a whole machine over DRAM.
namespace cbvh::testbench {

namespace {

Markup show(const Json& json, Figures& figures) {
  return show_machine(fmt::format("{}: {}", json.at("scene").get<std::string>(), json.at("output").get<std::string>()),
                      json, figures);
}

}  // namespace

ResultKind simulation_kind() {
  return {"simulation",  "cbvh sim --json", {"scene", "output", "bandwidth_bound_cycles", "traffic"},
          Chapter::runs, tally_machine,     show};
}

}  // namespace cbvh::testbench
