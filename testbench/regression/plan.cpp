// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/regression/plan.h"

#include <algorithm>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "testbench/backend/backend.h"
#include "testbench/regression/check_set.h"
#include "testbench/regression/committed_sets.h"
#include "testbench/regression/scene_sets.h"
#include "vectors/capture.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

using golden::InputError;

constexpr int kCapturedTreelet = 2;

/// How much a suite does.
struct Suite {
  std::string name;
  std::uint64_t stateless_cases;  ///< of each parameter set and mode
  std::uint64_t stateful_cases;
  std::vector<int> bits;
  std::vector<int> treelets;
  std::vector<std::string> stalls;
  bool shuffled_too;  ///< every mode again in shuffled order
  std::vector<std::string> scenes;
};

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"smoke", 4000, 60, {4, 6, 8}, {1, 2, 4}, {"none", "both"}, false, {"proc:cloth"}},
      {"full",
       20000,
       200,
       {2, 3, 4, 5, 6, 7, 8},
       {1, 2, 3, 4, 5, 6, 7, 8},
       {"none", "source", "sink", "both"},
       true,
       {"proc:cloth"}}};
  return all;
}

const Suite& find_suite(const std::string& name) {
  for (const Suite& suite : suites()) {
    if (suite.name == name) return suite;
  }
  throw InputError("--suite", fmt::format("unknown '{}', known: {}", name, fmt::join(suite_names(), ", ")));
}

std::vector<RunOptions> modes_of(const Suite& suite, const RegressionOptions& options) {
  std::vector<RunOptions> modes;
  for (const std::string& stalls : options.stalls.empty() ? suite.stalls : options.stalls) {
    RunOptions mode;
    mode.stalls = parse_stalls(stalls);
    mode.stall_seed = options.seed;
    mode.shuffle = options.shuffle;
    modes.push_back(mode);
    if (!suite.shuffled_too || options.shuffle || !options.stalls.empty()) continue;
    mode.shuffle = options.seed;
    modes.push_back(mode);
  }
  return modes;
}

/// Generated cases of one unit with one set of parameters.
PlannedSet generated_set(const vectors::UnitDescription& unit, const vectors::Parameters& parameters,
                         std::uint64_t cases, const std::string& backend, const RunOptions& run,
                         const RegressionOptions& options) {
  PlannedSet set;
  set.report.unit = unit.name;
  set.report.set = fmt::format("generated bits={}", parameters.bits);
  if (unit.treelets.size() > 1) set.report.set += fmt::format(" treelet={}", parameters.treelet);
  set.report.backend = backend;
  set.report.mode = mode_name(run);
  set.report.total_cases = cases;
  set.report.classes = empty_classes(unit);
  set.run = run;
  set.piece_size = unit.stateful ? 50 : 4000;
  const std::string rerun = rerun_line(options, set);
  set.work = [&unit, parameters, seed = options.seed, backend, run, rerun](const std::vector<std::uint64_t>& ids,
                                                                           SetReport& report) {
    const auto cases_of_piece = vectors::make_set(unit, parameters, seed);
    for (const std::uint64_t id : ids) cases_of_piece->generate_case(id);
    check_set(
        *cases_of_piece, *make_backend(backend), run,
        [&](std::uint64_t id) { return fmt::format("{} --only {}", rerun, id); }, report);
  };
  return set;
}

/// A set whose cases are there: a committed or a captured one. Its ids here are the indices of its cases.
PlannedSet fixed_set(const std::string& name, const std::shared_ptr<const vectors::VectorSet>& cases,
                     const std::string& backend, const RunOptions& run, const RegressionOptions& options) {
  PlannedSet set;
  set.report.unit = cases->unit().name;
  set.report.set = name;
  set.report.backend = backend;
  set.report.mode = mode_name(run);
  set.report.total_cases = cases->size();
  set.report.classes = empty_classes(cases->unit());
  set.run = run;
  set.piece_size = cases->unit().stateful ? 50 : 4000;
  const std::string rerun = rerun_line(options, set);
  set.work = [cases, backend, run, rerun](const std::vector<std::uint64_t>& indices, SetReport& report) {
    const auto piece = vectors::make_set(cases->unit(), cases->parameters(), cases->seed());
    for (const std::uint64_t index : indices) piece->copy_case(*cases, index);
    check_set(
        *piece, *make_backend(backend), run,
        [&](std::uint64_t id) { return fmt::format("{} --only {}", rerun, cases->find(id)); }, report);
  };
  return set;
}

Scene load(const std::string& spec) {
  return {spec, std::make_shared<const golden::FloatTree>(golden::build_lbvh(golden::load_scene(spec)))};
}

/// What a unit meets in a scene; nothing when it meets nothing there.
std::unique_ptr<vectors::VectorSet> capture(const vectors::UnitDescription& unit, const Scene& scene,
                                            const Suite& suite) {
  vectors::Parameters parameters;
  if (unit.treelets.size() > 1) parameters.treelet = kCapturedTreelet;
  vectors::CaptureOptions options;
  options.cases = unit.stateful ? suite.stateful_cases : suite.stateless_cases;
  try {
    return vectors::capture_set(unit.name, parameters, *scene.floats, options);
  } catch (const InputError&) {
    return nullptr;
  }
}

/// The parameter values that a suite wants and a unit takes.
std::vector<int> common(const std::vector<int>& wanted, const std::vector<int>& possible) {
  if (possible.size() == 1) return possible;
  std::vector<int> result;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(result),
               [&](int value) { return std::find(possible.begin(), possible.end(), value) != possible.end(); });
  return result;
}

}  // namespace

bool RegressionOptions::restricted() const {
  return !units.empty() || !stalls.empty() || shuffle || !set.empty() || only || !backends.empty();
}

bool RegressionOptions::wants(std::string_view unit) const {
  return units.empty() || std::find(units.begin(), units.end(), unit) != units.end();
}

std::vector<std::string> suite_names() {
  std::vector<std::string> names;
  for (const Suite& suite : suites()) names.push_back(suite.name);
  return names;
}

std::string rerun_line(const RegressionOptions& options, const PlannedSet& set) {
  std::string line =
      fmt::format("cbvh regress --suite {} --seed {} --backend {} --unit {} --set '{}' --stalls {}", options.suite,
                  options.seed, set.report.backend, set.report.unit, set.report.set, to_string(set.run.stalls));
  if (set.run.shuffle) line += fmt::format(" --shuffle {}", *set.run.shuffle);
  for (const std::string& scene : options.scenes) line += fmt::format(" --scene '{}'", scene);
  return line;
}

std::vector<PlannedSet> make_plan(const RegressionOptions& options) {
  const Suite& suite = find_suite(options.suite);
  for (const std::string& unit : options.units) vectors::find_unit(unit);
  const std::vector<RunOptions> all_modes = modes_of(suite, options);
  std::vector<Scene> scenes;
  for (const std::string& spec : options.scenes.empty() ? suite.scenes : options.scenes) scenes.push_back(load(spec));
  std::vector<PlannedSet> plan;
  for (const std::string& name : options.backends.empty() ? std::vector<std::string>{"rtl"} : options.backends) {
    const auto backend = make_backend(name);
    for (const std::string& unit : options.units) require_unit(*backend, vectors::find_unit(unit));
    std::vector<RunOptions> modes = all_modes;
    if (!backend->shuffles()) std::erase_if(modes, [](const RunOptions& mode) { return mode.shuffle.has_value(); });
    if (!backend->stalls()) std::erase_if(modes, [](const RunOptions& mode) { return mode.stalls != Stalls::none; });
    for (const vectors::UnitDescription& unit : vectors::units()) {
      if (!options.wants(unit.name) || !backend->has(unit)) continue;
      const std::uint64_t cases = unit.stateful ? suite.stateful_cases : suite.stateless_cases;
      for (const int bits : common(suite.bits, unit.bits)) {
        for (const int treelet : common(suite.treelets, unit.treelets)) {
          if (!backend->takes(unit, {bits, treelet})) continue;
          for (const RunOptions& mode : modes)
            plan.push_back(generated_set(unit, {bits, treelet}, cases, name, mode, options));
        }
      }
    }
    const auto append_fixed = [&](const std::string& set_name, std::unique_ptr<vectors::VectorSet> made) {
      const std::shared_ptr<const vectors::VectorSet> cases = std::move(made);
      if (!options.wants(cases->unit().name) || !backend->takes(cases->unit(), cases->parameters())) return;
      for (const RunOptions& mode : modes) plan.push_back(fixed_set(set_name, cases, name, mode, options));
    };
    for (const CommittedSet& committed : committed_sets()) {
      append_fixed(fmt::format("committed {}", committed.name),
                   vectors::parse_set(committed.bytes, std::string(committed.name)));
    }
    for (const Scene& scene : scenes) {
      for (const vectors::UnitDescription& unit : vectors::units()) {
        if (!options.wants(unit.name)) continue;
        if (auto captured = capture(unit, scene, suite)) append_fixed("captured " + scene.name, std::move(captured));
      }
    }
    if (name == "rtl" && options.wants(kSceneUnit)) {
      append_scene_sets(scenes, suite.treelets, suite.bits, modes, options, plan);
    }
  }
  if (!options.set.empty()) std::erase_if(plan, [&](const PlannedSet& set) { return set.report.set != options.set; });
  if (plan.empty()) throw InputError("regress", "nothing to run: no set fits --unit, --set and --backend");
  return plan;
}

}  // namespace cbvh::testbench
