// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
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

int run(const Options& options) {
  const std::size_t steps = 2 + options.sizes.size();
  Progress progress("bench", steps);
  Json json = {{"axis_compressor", bench_axis(options.cases)}};
  progress.step();
  json["build"] = bench_build(options.scene);
  progress.step();
  Json scaling = Json::array();
  for (const std::uint64_t size : options.sizes) {
    scaling.push_back(bench_build(fmt::format("proc:terrain,triangles={}", size)));
    progress.step();
  }
  json["scaling"] = scaling;
  std::string text;
  for (const auto& [key, value] : json["axis_compressor"].items())
    text += fmt::format("axis_compressor {:<30} {}\n", key, value.dump());
  text += fmt::format("{:<34} {:>10} {:>9} {:>12} {:>10} {:>14} {}\n", "scene", "triangles", "seconds", "cycles",
                      "cycles/pair", "pairs/s", "identical");
  std::vector<Json> rows(scaling.begin(), scaling.end());
  rows.insert(rows.begin(), json["build"]);
  bool pass = json["axis_compressor"]["failures"] == 0;
  for (const Json& row : rows) {
    text += fmt::format("{:<34} {:>10} {:>9.2f} {:>12} {:>10.3f} {:>14.0f} {}\n", row["scene"].get<std::string>(),
                        row["triangles"].get<std::uint64_t>(), row["seconds"].get<double>(),
                        row["cycles"].get<std::uint64_t>(), row["cycles_per_pair"].get<double>(),
                        row["pairs_per_second"].get<double>(), row["identical"].dump());
    pass = pass && row["identical"].get<bool>();
  }
  options.output.text(text);
  options.output.json(json);
  return pass ? kPass : kMismatch;
}

}  // namespace

void add_bench_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  CLI::App& command =
      commands.add("bench", "Measures the model against the golden, text vectors, and builds of growing scenes",
                   [options] { return run(*options); });
  command.add_option("--cases", options->cases, "axis compressor cases")->capture_default_str();
  command.add_option("--scene", options->scene, "the scene to build")->capture_default_str()->type_name("SCENE");
  command.add_option("--sizes", options->sizes, "triangles of the terrains to build")
      ->capture_default_str()
      ->type_name("N...");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
