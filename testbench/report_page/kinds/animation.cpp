// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "testbench/report_page/plot.h"
#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh animate`: each policy's frames.
namespace cbvh::testbench {

namespace {

constexpr double kMilliseconds = 1e3;

double frame_seconds(const Json& frame) {
  return frame.at("update_seconds").get<double>() + frame.at("trace_seconds").get<double>();
}

double relative_sah(const Json& frame) { return frame.at("sah").get<double>() / frame.at("fresh_sah").get<double>(); }

double milliseconds(const Json& frame) { return kMilliseconds * frame_seconds(frame); }

Tally tally(const Json& json) {
  Tally tally;
  for (const Json& frames : json.at("policies")) {
    for (const Json& frame : frames) tally += one_check(frame.at("same_picture").get<bool>());
  }
  return tally;
}

Plot plot_of(const Json& json, const std::string& title, const Axis& y, double (*value)(const Json&)) {
  Plot plot{title, {"frame", false, false, true}, y, {}};
  for (const auto& [policy, frames] : json.at("policies").items()) {
    Series series{policy, {}};
    for (const Json& frame : frames) series.points.push_back({static_cast<double>(series.points.size()), value(frame)});
    plot.series.push_back(series);
  }
  return plot;
}

Markup summary(const Json& json) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [policy, frames] : json.at("policies").items()) {
    double seconds = 0;
    double longest = 0;
    double worst = 0;
    std::size_t same = 0;
    for (const Json& frame : frames) {
      seconds += frame_seconds(frame);
      if (&frame != &frames.front()) longest = std::max(longest, frame_seconds(frame));
      worst = std::max(worst, relative_sah(frame));
      same += frame.at("same_picture").get<bool>() ? 1 : 0;
    }
    rows.push_back({policy, fmt::format("{:.3f}", kMilliseconds * seconds / static_cast<double>(frames.size())),
                    fmt::format("{:.3f}", kMilliseconds * longest), fmt::format("{:.3f}", worst),
                    fmt::format("{} of {}", same, frames.size())});
  }
  return plain_table(
      "Policies", {"policy", "frame, ms", "longest but the first, ms", "worst SAH", "pictures as of a new tree"}, rows);
}

Markup show(const Json& json, Figures& figures) {
  const std::string scene = json.at("scene");
  Markup markup = element("h3", fmt::format("{}, built by {}", scene, json.at("builder").get<std::string>()));
  markup += summary(json);
  markup +=
      draw(plot_of(json, "Frame times: update and picture", {"frame time, ms", true, false}, milliseconds), figures);
  markup += draw(
      plot_of(json, "Quality of the tree over the frames", {"SAH over that of a new tree", false, false}, relative_sah),
      figures);
  return markup;
}

}  // namespace

ResultKind animation_kind() {
  return {"animation", "cbvh animate --json", {"policies", "builder", "scene"}, Chapter::animations, tally, show};
}

}  // namespace cbvh::testbench
