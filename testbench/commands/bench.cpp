// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "golden/scene/load.h"
#include "testbench/backend/backend.h"
#include "testbench/build_report.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/progress.h"
#include "testbench/scoreboard/scoreboard.h"
#include "testbench/sim/simulate.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::uint64_t cases = 1000000;
  std::string scene = "proc:cloth";
  std::vector<std::uint64_t> sizes = {10000, 100000, 1000000, 4000000};
  Output output;
};

template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double per_second(std::uint64_t count, double seconds) {
  return seconds > 0 ? static_cast<double>(count) / seconds : 0;
}

/// Cases in memory at a time, as in a regression: enough to fill the pipeline, few enough to stay in the cache.
constexpr std::uint64_t kBatch = 10000;

/// The axis compressor on machine integers against the golden's exact arithmetic, and both through text.
Json bench_axis(std::uint64_t cases) {
  const auto rtl = make_backend("rtl");
  const auto golden = make_backend("golden");
  double generate = 0;
  double simulate = 0;
  double compare_seconds = 0;
  double reference = 0;
  double write = 0;
  double check = 0;
  SetReport compared;
  SetReport text_report;
  for (std::uint64_t first = 0; first < cases; first += kBatch) {
    const auto set = vectors::make_set(vectors::find_unit("axis_compressor"), {}, 1);
    generate += seconds_of([&] {
      for (std::uint64_t id = first; id < std::min(cases, first + kBatch); ++id) set->generate_case(id);
    });
    Responses found(set->response_codec().object_size);
    simulate += seconds_of([&] { found = rtl->run(*set, {}); });
    compare_seconds += seconds_of([&] { compare(*set, found, {}, compared); });
    reference += seconds_of([&] { golden->run(*set, {}); });
    std::string text;
    write += seconds_of([&] { text = vectors::serialize(*set, vectors::Format::text); });
    check += seconds_of([&] {
      const auto reader = vectors::open_bytes(text, "bench.vec");
      const auto batch = reader->empty_set();
      while (reader->next(*batch, kBatch)) compare(*batch, rtl->run(*batch, {}), {}, text_report);
    });
  }
  return {{"cases", cases},
          {"failures", compared.failures + text_report.failures},
          {"rtl_cases_per_second", per_second(cases, simulate)},
          {"golden_cases_per_second", per_second(cases, reference)},
          {"rtl_per_golden", reference / simulate},
          {"generate_cases_per_second", per_second(cases, generate)},
          {"compare_cases_per_second", per_second(cases, compare_seconds)},
          {"text_write_lines_per_second", per_second(cases, write)},
          {"text_check_lines_per_second", per_second(cases, check)}};
}

Json bench_build(const std::string& scene) {
  BuildJob job;
  job.stream.treelet = 4;
  golden::Mesh mesh;
  const double load = seconds_of([&] { mesh = golden::load_scene(scene); });
  const Json figures = build_and_compare(mesh, job).json;
  const double seconds = figures.at("seconds");
  const std::uint64_t pairs = figures.at("pairs");
  return {{"scene", scene},
          {"triangles", figures.at("triangles")},
          {"load_seconds", load},
          {"seconds", seconds},
          {"cycles", figures.at("cycles")},
          {"cycles_per_pair", per_second(figures.at("cycles"), static_cast<double>(pairs))},
          {"pairs_per_second", per_second(pairs, seconds)},
          {"identical", figures.at("identical")}};
}

/// The whole pipeline over DRAM; nobody looks on.
Json bench_sim(const golden::Mesh& mesh) {
  SimRequest request;
  request.config = load_sim_config("streaming-modulo");
  request.machine.utilisation = false;
  request.machine.progress = false;
  const SimResult result = simulate_lbvh(mesh, request);
  return {{"scene", mesh.name},
          {"triangles", result.triangles},
          {"seconds", result.seconds},
          {"cycles", result.cycles},
          {"cycles_per_second", per_second(result.cycles, result.seconds)},
          {"over_bandwidth_bound", result.over_bound()},
          {"identical", result.pass()}};
}

/// Rows of one kind: what was simulated, how long it took, and whether it was the golden's tree.
std::string rows_text(const std::string& title, const std::vector<Json>& rows, bool& pass) {
  std::string text = fmt::format("\n{:<34} {:>10} {:>9} {:>12} {:>14} {:>12} {}\n", title, "triangles", "seconds",
                                 "cycles", "cycles/s", "triangles/s", "identical");
  for (const Json& row : rows) {
    const double seconds = row["seconds"];
    text +=
        fmt::format("{:<34} {:>10} {:>9.2f} {:>12} {:>14.0f} {:>12.0f} {}\n", row["scene"].get<std::string>(),
                    row["triangles"].get<std::uint64_t>(), seconds, row["cycles"].get<std::uint64_t>(),
                    per_second(row["cycles"], seconds), per_second(row["triangles"], seconds), row["identical"].dump());
    pass = pass && row["identical"].get<bool>();
  }
  return text;
}

int run(const Options& options) {
  Progress progress("bench", 1 + 2 * (1 + options.sizes.size()));
  Json json = {{"axis_compressor", bench_axis(options.cases)}};
  progress.step();
  std::vector<std::string> scenes = {options.scene};
  for (const std::uint64_t size : options.sizes) scenes.push_back(fmt::format("proc:terrain,triangles={}", size));
  std::vector<Json> builds;
  std::vector<Json> sims;
  for (const std::string& scene : scenes) {
    builds.push_back(bench_build(scene));
    progress.step();
    sims.push_back(bench_sim(golden::load_scene(scene)));
    progress.step();
  }
  json["build"] = builds.front();
  json["scaling"] = std::vector<Json>(builds.begin() + 1, builds.end());
  json["sim"] = sims;
  std::string text;
  for (const auto& [key, value] : json["axis_compressor"].items())
    text += fmt::format("axis_compressor {:<30} {}\n", key, value.dump());
  bool pass = json["axis_compressor"]["failures"] == 0;
  text += rows_text("build: stream compressor, ideal memory", builds, pass);
  text += rows_text("sim: whole pipeline, DRAM", sims, pass);
  options.output.text(text);
  options.output.json(json);
  return pass ? kPass : kMismatch;
}

}  // namespace

void add_bench_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "bench", "Measures the model against the golden, text vectors, and builds and simulations of growing scenes",
      [options] { return run(*options); });
  command.add_option("--cases", options->cases, "axis compressor cases").capture_default_str();
  command.add_option("--scene", options->scene, "the scene to build").capture_default_str().type_name("SCENE");
  command.add_option("--sizes", options->sizes, "triangles of the terrains to build")
      .capture_default_str()
      .type_name("N...");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
