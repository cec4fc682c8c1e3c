// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <stdexcept>

#include "testbench/report_page/kinds/machine.h"
#include "testbench/report_page/plot.h"

/// `cbvh refit`: the refit unit's frames. The first is shown in full.
namespace cbvh::testbench {

namespace {

Tally tally(const Json& json) {
  Tally tally;
  for (const Json& frame : json.at("frames")) tally += tally_machine(frame);
  return tally;
}

Markup show(const Json& json, Figures& figures) {
  const Json& frames = json.at("frames");
  if (frames.empty()) throw std::invalid_argument("no frames");
  Markup markup = show_machine(
      fmt::format("{} refitted to {}", json.at("tree").get<std::string>(), json.at("scene").get<std::string>()),
      frames.front(), figures);
  Series series{"refit", {}};
  for (const Json& frame : frames)
    series.points.push_back({static_cast<double>(series.points.size()), frame.at("milliseconds").get<double>()});
  if (frames.size() > 1)
    markup += draw(
        Plot{"Refit times", {"frame", false, false, true}, {"refit, ms at its clock", false, true}, {series}}, figures);
  return markup;
}

}  // namespace

ResultKind refit_kind() {
  return {"refit", "cbvh refit --json", {"tree", "scene", "frames"}, Chapter::runs, tally, show};
}

}  // namespace cbvh::testbench
