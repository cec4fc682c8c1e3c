// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/runtime.h"

#include "golden/input_error.h"
#include "testbench/sim/simulate.h"

namespace cbvh::testbench {

namespace {

/// The named configurations of the simulator are the columns of the paper's Table 2, in its order.
RuntimeRow measure(const golden::Mesh& mesh, const EvalRules& rules) {
  RuntimeRow row{mesh.name, {}, {}, 0};
  const std::vector<std::string> names = sim_config_names();
  for (std::size_t i = 0; i < kRuntimes; ++i) {
    SimRequest request;
    request.config = load_sim_config(names.at(i));
    request.config.scale_rule = rules.scale_rule;
    request.config.min_scale = rules.min_scale;
    request.machine.utilisation = false;
    request.machine.progress = false;
    const SimResult result = simulate_lbvh(mesh, request);
    if (!result.pass())
      throw golden::InputError(mesh.name, fmt::format("{}: not the golden's tree: {}", names[i], result.difference));
    row.milliseconds.at(i) = result.milliseconds();
    row.over_dram_bound.at(i) = result.over_bound();
    row.leaf_size = static_cast<double>(result.triangles) / static_cast<double>(result.leaves);
  }
  return row;
}

}  // namespace

MeasureRuntime runtime_measurement() { return measure; }

}  // namespace cbvh::testbench
