// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/board/selftest.h"

#include <algorithm>

#include "testbench/backend/backend.h"
#include "testbench/regression/check_set.h"
#include "testbench/regression/regress.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

Report selftest_board(const BoardSelftest& options) {
  const std::shared_ptr<const Backend> board = make_backend("board");
  std::vector<PlannedSet> plan;
  for (const vectors::UnitDescription& unit : vectors::units()) {
    if (!board->has(unit)) continue;
    const std::uint64_t cases =
        unit.stateful ? std::max<std::uint64_t>(options.cases / 10, unit.generated_classes()) : options.cases;
    for (const int bits : unit.bits) {
      for (const int treelet : unit.treelets) {
        const vectors::Parameters parameters{bits, treelet};
        if (!board->takes(unit, parameters)) continue;
        PlannedSet set;
        set.report.unit = unit.name;
        set.report.set = fmt::format("selftest bits={} treelet={}", bits, treelet);
        set.report.backend = "board";
        set.report.mode = mode_name(set.run);
        set.report.total_cases = cases;
        set.report.classes = empty_classes(unit);
        set.piece_size = cases;
        set.work = [&unit, parameters, board, run = set.run, seed = options.seed](const std::vector<std::uint64_t>& ids,
                                                                                  SetReport& report) {
          const auto generated = vectors::make_set(unit, parameters, seed);
          for (const std::uint64_t id : ids) generated->generate_case(id);
          check_set(
              *generated, *board, run,
              [&](std::uint64_t id) {
                return fmt::format(
                    "cbvh gen --unit {} --bits {} --treelet {} --seed {} --cases {} -o selftest.vec && "
                    "cbvh check selftest.vec --backend board --only {}",
                    unit.name, parameters.bits, parameters.treelet, seed, id + 1, id);
              },
              report);
        };
        plan.push_back(std::move(set));
      }
    }
  }
  Report report;
  report.command = "board selftest";
  report.seed = options.seed;
  RegressionOptions how;
  run_plan(plan, how, report);
  return report;
}

}  // namespace cbvh::testbench
