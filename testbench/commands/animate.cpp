// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "golden/scene/load.h"
#include "testbench/animate/animation.h"
#include "testbench/command_line.h"
#include "testbench/option_values.h"
#include "testbench/output.h"
#include "testbench/scene_of_frame.h"

namespace cbvh::testbench {

namespace {

struct Options {
  MovingScene scene{"", 0, 60};
  std::vector<std::string> policies;
  AnimationJob job;
  Output output;
};

using Results = std::vector<FrameResult>;

template <class Member>
double mean(const Results& frames, Member member) {
  double sum = 0;
  for (const FrameResult& frame : frames) sum += static_cast<double>(std::invoke(member, frame));
  return sum / static_cast<double>(frames.size());
}

/// The largest frame time but for the first frame, in which every policy builds.
double longest(const Results& frames) {
  double most = 0;
  for (std::size_t i = std::min<std::size_t>(1, frames.size() - 1); i < frames.size(); ++i)
    most = std::max(most, frames[i].seconds());
  return most;
}

Json to_json(const Results& frames) {
  Json list = Json::array();
  for (const FrameResult& frame : frames) {
    list.push_back({{"update_seconds", frame.update_seconds},
                    {"trace_seconds", frame.trace_seconds},
                    {"sah", frame.sah},
                    {"fresh_sah", frame.fresh_sah},
                    {"box_tests", frame.box_tests},
                    {"age", frame.age},
                    {"same_picture", frame.same_picture}});
  }
  return list;
}

std::string to_csv(const std::string& policy, const Results& frames) {
  std::string csv;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameResult& f = frames[i];
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", policy, i, f.update_seconds, f.trace_seconds, f.sah, f.fresh_sah,
                       f.box_tests, f.age, f.same_picture ? 1 : 0);
  }
  return csv;
}

std::string to_row(const std::string& policy, const Results& frames, bool same) {
  const auto relative = [](const FrameResult& frame) { return frame.sah / frame.fresh_sah; };
  double worst = 0;
  for (const FrameResult& frame : frames) worst = std::max(worst, relative(frame));
  return fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.3f} | {:.3f} | {:.1f} | {} |\n", policy,
                     1e3 * mean(frames, &FrameResult::update_seconds), 1e3 * mean(frames, &FrameResult::trace_seconds),
                     1e3 * mean(frames, &FrameResult::seconds), 1e3 * longest(frames),
                     1 / mean(frames, &FrameResult::seconds), mean(frames, relative), worst,
                     mean(frames, &FrameResult::age), same ? "all" : "NOT ALL");
}

std::vector<std::shared_ptr<const golden::Mesh>> meshes_of(const MovingScene& scene, Progress& progress) {
  std::vector<std::shared_ptr<const golden::Mesh>> meshes;
  for (unsigned frame = 0; frame < scene.frames; ++frame) {
    meshes.push_back(std::make_shared<const golden::Mesh>(scene_of_frame(scene, frame)));
    progress.step();
  }
  return meshes;
}

int run(const Options& options) {
  check_animation_job(options.job);
  check_moving_scene(options.scene);
  const std::vector<std::string> known(golden::kUpdatePolicies.begin(), golden::kUpdatePolicies.end());
  const std::vector<std::string>& policies = options.policies.empty() ? known : options.policies;
  for (const std::string& policy : policies) choice("--policy", policy, known);

  Progress progress("animate", options.scene.frames * (2 + policies.size()));
  const FreshFrames fresh(meshes_of(options.scene, progress), options.job, progress);
  std::string text = fmt::format(
      "{}, {} frames, {}; milliseconds; SAH over that of a tree built of the frame\n\n"
      "| policy | update | trace | frame | longest | frames/s | SAH | worst SAH | age | same picture |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n",
      options.scene.scene, options.scene.frames, options.job.builder);
  std::string csv = "policy,frame,update_seconds,trace_seconds,sah,fresh_sah,box_tests,age,same_picture\n";
  Json json = {{"scene", options.scene.scene}, {"builder", options.job.builder}, {"policies", Json::object()}};
  bool pass = true;
  for (const std::string& policy : policies) {
    const auto which = static_cast<golden::UpdatePolicy>(choice("--policy", policy, known));
    const Results frames = animate(fresh, which, options.job, progress);
    const bool same =
        std::all_of(frames.begin(), frames.end(), [](const FrameResult& frame) { return frame.same_picture; });
    pass = pass && same;
    text += to_row(policy, frames, same);
    csv += to_csv(policy, frames);
    json["policies"][policy] = to_json(frames);
  }
  json["pass"] = pass;
  options.output.text(text);
  options.output.csv(csv);
  options.output.json(json);
  return pass ? kPass : kMismatch;
}

}  // namespace

void add_animate_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command =
      commands.add("animate", "Follows a moving scene with its tree: refitted, rebuilt, or rebuilt beside the frames",
                   [options] { return run(*options); });
  command.add_option("scene", options->scene.scene, "{time} in it goes from 0 to 1 over the frames")
      .required()
      .type_name("SCENE");
  command.add_option("--policy", options->policies, "refit, rebuild, heuristic or async; all, if none is named")
      .delimiter(',');
  command.add_option("--frames", options->scene.frames, "how many").capture_default_str();
  command
      .add_option("--twist", options->scene.twist, "turn the scene around its y axis, up to so many turns at its top")
      .capture_default_str();
  command.add_option("--builder", options->job.builder, "NAME[,key=value...], as build takes it; without threads")
      .capture_default_str();
  command.add_option("--threads", options->job.threads, "N, threads of a frame").capture_default_str();
  command
      .add_option("--build-threads", options->job.build_threads,
                  "K, threads that async builds on; N - K, but at least one, draw frames meanwhile")
      .capture_default_str();
  command
      .add_option("--rebuild-above", options->job.rebuild_above,
                  "heuristic builds when nodes have grown, on average, by this factor against their children")
      .capture_default_str();
  command.add_option("--width", options->job.width, "of the picture, pixels").capture_default_str();
  command.add_option("--height", options->job.height, "of the picture, pixels").capture_default_str();
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
