// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/sim_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace cbvh::testbench {

namespace {

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string traffic_text(const SimResult& result) {
  std::string text = fmt::format("\n{:<26} {:>10} {:>10} {:>13} {:>13} {:>11}  {}\n", "traffic", "reads", "writes",
                                 "counted bytes", "model bytes", "difference", "why");
  for (const TrafficRow& row : result.traffic) {
    text += fmt::format("{:<26} {:>10} {:>10} {:>13} {:>13} {:>+11}  {}{}\n", row.purpose, row.reads, row.writes,
                        row.counted_bytes(), row.model_bytes, row.difference(), row.explanation,
                        row.exact() ? "" : "  UNEXPLAINED");
  }
  return text +
         fmt::format(
             "{} bytes in all, {:.3f} of the {} that a separate top-down pass would make (by the model {:.3f})\n",
             result.counted_bytes(), result.traffic_ratio(), result.baseline_bytes, result.model_ratio());
}

std::string utilisation_text(const SimResult& result) {
  if (result.utilisation.empty()) return "";
  std::string text = fmt::format("\n{:<22} {:>11} {:>7} {:>16} {:>17} {:>7}   of {} cycles\n", "module", "busy", "busy",
                                 "stalled on input", "stalled on output", "idle", result.cycles);
  for (const rtl::ModuleUse& use : result.utilisation) {
    text += fmt::format("{:<22} {:>11} {:>6.1f}% {:>15.1f}% {:>16.1f}% {:>6.1f}%\n", use.module, use.busy,
                        100 * share(use.busy, result.cycles), 100 * share(use.stalled_on_input, result.cycles),
                        100 * share(use.stalled_on_output, result.cycles), 100 * share(use.idle, result.cycles));
  }
  return text;
}

}  // namespace

std::uint64_t SimResult::counted_bytes() const {
  return std::accumulate(traffic.begin(), traffic.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const TrafficRow& row) { return sum + row.counted_bytes(); });
}

double SimResult::model_ratio() const {
  const auto bytes = std::accumulate(traffic.begin(), traffic.end(), std::uint64_t{0},
                                     [](std::uint64_t sum, const TrafficRow& row) { return sum + row.model_bytes; });
  return static_cast<double>(bytes) / static_cast<double>(baseline_bytes);
}

bool SimResult::traffic_explained() const {
  return std::all_of(traffic.begin(), traffic.end(), [](const TrafficRow& row) { return row.exact(); });
}

std::string bottleneck(const SimResult& result) {
  if (result.bound_cycles > 0 && result.over_bound() <= 1.25) {
    return fmt::format("the memory's bandwidth: {:.1f} % of the cycles are what its bytes need at peak",
                       100 / result.over_bound());
  }
  const rtl::ModuleUse* busiest = nullptr;
  double most = 0;
  for (const rtl::ModuleUse& use : result.utilisation) {
    if (use.module == "memory" || use.module == "driver") continue;
    const double in_use = share(use.busy, use.busy + use.stalled_on_input + use.stalled_on_output);
    if (in_use <= most || use.busy * 20 < result.cycles) continue;
    busiest = &use;
    most = in_use;
  }
  if (busiest == nullptr) return "not told: run with the utilisation table";
  if (most >= 0.9) return fmt::format("{}: busy in {:.0f} % of its active cycles", busiest->module, 100 * most);
  return fmt::format(
      "latency: no module is busy all the time ({} most, in {:.0f} % of its active cycles), nor is the memory",
      busiest->module, 100 * most);
}

Json to_json(const SimResult& result) {
  Json json = {{"scene", result.scene},
               {"output", result.output},
               {"triangles", result.triangles},
               {"leaves", result.leaves},
               {"pairs", result.pairs},
               {"e_min", result.min_scale},
               {"identical", result.identical},
               {"difference", result.difference},
               {"digest", result.digest},
               {"golden_digest", result.golden_digest},
               {"backtracks", result.golden_repairs},
               {"hardware_backtracks", result.repairs},
               {"cycles", result.cycles},
               {"clock_mhz", result.clock_mhz},
               {"milliseconds", result.milliseconds()},
               {"bandwidth_bound_cycles", result.bound_cycles},
               {"over_bandwidth_bound", result.over_bound()},
               {"runs", result.runs},
               {"merge_passes", result.merge_passes},
               {"counted_bytes", result.counted_bytes()},
               {"baseline_bytes", result.baseline_bytes},
               {"traffic_ratio", result.traffic_ratio()},
               {"model_traffic_ratio", result.model_ratio()}};
  for (const auto& [phase, cycle] : result.phases) json["phases"][phase] = cycle;
  for (const TrafficRow& row : result.traffic) {
    json["traffic"].push_back({{"purpose", row.purpose},
                               {"reads", row.reads},
                               {"writes", row.writes},
                               {"counted_bytes", row.counted_bytes()},
                               {"model_bytes", row.model_bytes},
                               {"explained_bytes", row.explained_bytes},
                               {"explanation", row.explanation},
                               {"exact", row.exact()}});
  }
  for (const MemoryStatistic& statistic : result.memory) {
    json["memory"][statistic.name] = {
        {"value", statistic.value}, {"unit", statistic.unit}, {"description", statistic.description}};
  }
  for (const rtl::ModuleUse& use : result.utilisation) {
    json["utilisation"][use.module] = {{"busy", use.busy},
                                       {"stalled_on_input", use.stalled_on_input},
                                       {"stalled_on_output", use.stalled_on_output},
                                       {"idle", use.idle}};
  }
  json["bottleneck"] = bottleneck(result);
  json["pass"] = result.pass();
  json["seconds"] = result.seconds;
  json["cycles_per_second"] = result.seconds > 0 ? static_cast<double>(result.cycles) / result.seconds : 0;
  return json;
}

std::string to_text(const SimResult& result) {
  std::string text = fmt::format("{} {}: {} triangles, {} leaves, {} pairs, e_min {}\n", result.scene, result.output,
                                 result.triangles, result.leaves, result.pairs, result.min_scale);
  text += fmt::format("{} cycles, {:.3f} ms at {:.0f} MHz", result.cycles, result.milliseconds(), result.clock_mhz);
  if (result.bound_cycles > 0)
    text += fmt::format(", {:.3f} of what the counted bytes need at peak bandwidth", result.over_bound());
  text += '\n';
  for (const auto& [phase, cycle] : result.phases) text += fmt::format("  {} until cycle {}\n", phase, cycle);
  if (result.runs > 0) text += fmt::format("  {} sorted runs, {} merge passes\n", result.runs, result.merge_passes);
  text += traffic_text(result) + utilisation_text(result);
  text += fmt::format("\n{:<26} {:>15} {}\n", "memory", "value", "unit");
  for (const MemoryStatistic& statistic : result.memory) {
    text += fmt::format("{:<26} {:>15} {:<10} {}\n", statistic.name, fmt::format("{:.8g}", statistic.value),
                        statistic.unit, statistic.description);
  }
  text += fmt::format("\nbottleneck: {}\n", bottleneck(result));
  text += fmt::format("simulated in {:.2f} s, {:.2f} million cycles a second\n", result.seconds,
                      result.seconds > 0 ? static_cast<double>(result.cycles) / result.seconds / 1e6 : 0);
  if (!result.digest.empty())
    text += fmt::format("digest {}, backtracks {} (golden {}, {})\n", result.digest, result.repairs,
                        result.golden_digest, result.golden_repairs);
  text += result.identical ? "memory holds the golden's tree, bit for bit\n"
                           : fmt::format("memory DIFFERS from the golden's tree: {}\n", result.difference);
  return text;
}

}  // namespace cbvh::testbench
