// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/report/json.h"
#include "testbench/report_page/figure.h"
#include "testbench/report_page/markup.h"

namespace cbvh::testbench {

/// Checks of a result.
struct Tally {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::uint64_t skipped = 0;  ///< cases, or runs, that belong to it and were not run

  Tally& operator+=(const Tally& more);
};

/// Without any check nothing has passed.
enum class Outcome { passed, failed, nothing_checked };
Outcome outcome(const Tally& tally);

/// The chapters of the page.
enum class Chapter { checks, evaluations, runs, rays, animations, speed };

/// The count of this name. Throws std::invalid_argument when it is no count.
std::uint64_t count(const Json& json, const char* key);

/// One check that passed or not.
Tally one_check(bool passed);

/// A form of JSON that commands write. Functions throw std::exception when the JSON is not of this form.
struct ResultKind {
  std::string name;
  std::string command;            ///< that writes it
  std::vector<std::string> keys;  ///< what tells it from all others
  Chapter chapter;
  Tally (*tally)(const Json& json);
  Markup (*show)(const Json& json, Figures& figures);
};

/// What a command wrote, recognised.
struct Result {
  std::string place;
  ResultKind kind;
  Json json;
  std::string version;       ///< of cbvh; "-" when the file does not say
  std::string command_line;  ///< the same
};

// Each is in its file in kinds/.
ResultKind animation_kind();
ResultKind bench_kind();
ResultKind build_kind();
ResultKind checks_kind();
ResultKind evaluation_kind();
ResultKind lockstep_kind();
ResultKind refit_kind();
ResultKind simulation_kind();
ResultKind trace_kind();
ResultKind units_kind();

}  // namespace cbvh::testbench
