// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "testbench/command_line.h"
#include "testbench/eval/builders/command.h"
#include "testbench/eval/findings.h"
#include "testbench/eval/rays/command.h"
#include "testbench/eval/sections.h"
#include "testbench/eval/space/command.h"
#include "testbench/eval/two_level/command.h"
#include "testbench/option_values.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::vector<std::string> scenes = {"proc:cloth",    "proc:spheres", "proc:terrain",
                                     "proc:hairball", "proc:city",    "proc:explode"};
  std::vector<std::string> only;
  std::string scale_rule = "equation2";
  std::string min_scale = "auto";
  std::vector<std::string> min_scales = {"-126", "-60", "-30", "-25", "-20", "-15", "-10", "-5"};
  unsigned jobs = 0;
  Output output;
};

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const Section& section : known_sections()) names.push_back(section.name);
  return names;
}

/// The sections asked for, in their own order; all without --only.
std::vector<Section> chosen_sections(const std::vector<std::string>& only) {
  std::vector<Section> known = known_sections();
  if (only.empty()) return known;
  std::vector<bool> wanted(known.size(), false);
  for (const std::string& name : only) wanted[choice("--only", name, section_names())] = true;
  std::vector<Section> sections;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (wanted[i]) sections.push_back(known[i]);
  }
  return sections;
}

bool contains(const std::vector<Section>& sections, const std::string& name) {
  return std::any_of(sections.begin(), sections.end(), [&](const Section& section) { return section.name == name; });
}

EvalJob make_job(const Options& options, const std::vector<Section>& sections) {
  EvalJob job;
  job.scenes = options.scenes;
  job.threads = options.jobs;
  job.rules.scale_rule = choice("--scale-rule", options.scale_rule, {"equation2", "figure5"}) == 0
                             ? golden::ScaleRule::equation2
                             : golden::ScaleRule::figure5;
  job.rules.min_scale = parse_min_scale("--min-scale", options.min_scale);
  for (const std::string& scale : options.min_scales) {
    if (std::count(options.min_scales.begin(), options.min_scales.end(), scale) > 1)
      throw golden::InputError("--min-scales", fmt::format("found {} twice, want each scale once", scale));
    const std::optional<int> parsed = parse_min_scale("--min-scales", scale);
    if (contains(sections, "figure10")) job.sweep.push_back(parsed);
  }
  if (contains(sections, "table2")) job.runtime = runtime_measurement();
  return job;
}

int run(const Options& options) {
  const std::vector<Section> sections = chosen_sections(options.only);
  const std::vector<SceneMeasure> scenes = measure_scenes(make_job(options, sections));
  Findings findings;
  findings.add_all(scenes);
  findings.tables = {scenes_table(scenes)};
  for (const Section& section : sections) {
    for (Table& table : section.tables(scenes)) findings.tables.push_back(std::move(table));
  }
  return report(findings, options.output,
                fmt::format("# Evaluation of {} scenes: scale rule {}, minimum scale {}\n\n", scenes.size(),
                            options.scale_rule, options.min_scale),
                {{"scale_rule", options.scale_rule}, {"min_scale", options.min_scale}});
}

}  // namespace

void add_eval_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  auto chosen = std::make_shared<std::function<int()>>([options] { return run(*options); });
  const Command command = commands.add("eval", "The paper's evaluation for any scenes, beside the paper's own figures",
                                       [chosen] { return (*chosen)(); });
  add_builders_evaluation(command, chosen);
  add_space_evaluation(command, chosen);
  add_rays_evaluation(command, chosen);
  add_two_level_evaluation(command, chosen);
  command.add_option("scenes", options->scenes, "each a .glb, .gltf, .obj or .ply file, or proc:NAME[,key=value...]")
      .type_name("SCENE...")
      .capture_default_str();
  command.add_option("--only", options->only, fmt::format("sections, of {}", fmt::join(section_names(), ",")))
      .delimiter(',')
      .allow_extra_args(false)
      .type_name("SECTION,...");
  command.add_option("--scale-rule", options->scale_rule, "equation2, or figure5 to compare with the paper's tables")
      .capture_default_str();
  command.add_option("--min-scale", options->min_scale, "e_min: auto, or an exponent -149..127; the paper's is -30")
      .capture_default_str();
  command.add_option("--min-scales", options->min_scales, "those of Figure 10")
      .delimiter(',')
      .allow_extra_args(false)
      .type_name("E,...")
      .capture_default_str();
  command.add_option("-j,--jobs,--threads", options->jobs, "threads; 0: one a core").capture_default_str();
  command.footer(golden::procedural_scene_help());
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
