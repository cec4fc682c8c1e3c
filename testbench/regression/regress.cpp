// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/regression/regress.h"

#include <algorithm>
#include <ctime>

#include "golden/threads/parallel_for.h"
#include "testbench/backend/backend.h"
#include "testbench/gateware/process.h"
#include "testbench/progress.h"
#include "testbench/rtl/counting_bits.h"

namespace cbvh::testbench {

namespace {

/// What one thread does at a time.
struct Piece {
  std::size_t set;
  std::vector<std::uint64_t> ids;
  SetReport found;
  CornerCounts corners{};
};

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

std::vector<Piece> make_pieces(const std::vector<PlannedSet>& plan, const RegressionOptions& options) {
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < plan.size(); ++s) {
    const std::uint64_t first = plan[s].first_id;
    std::vector<std::uint64_t> ids;
    for (std::uint64_t id = first; id < first + plan[s].report.total_cases; ++id) {
      if (!owns(options.shard, id) || (options.only && *options.only != id)) continue;
      ids.push_back(id);
      if (ids.size() < plan[s].piece_size) continue;
      pieces.push_back({s, std::move(ids), plan[s].report});
      ids.clear();
    }
    if (!ids.empty()) pieces.push_back({s, std::move(ids), plan[s].report});
  }
  return pieces;
}

bool observes_corners(const PlannedSet& set) { return make_backend(set.report.backend)->observes_corners(); }

}  // namespace

void run_plan(const std::vector<PlannedSet>& plan, const RegressionOptions& options, Report& report) {
  std::vector<Piece> pieces = make_pieces(plan, options);
  {
    Progress progress(report.command, pieces.size());
    golden::parallel_for(pieces.size(), options.threads, [&](std::size_t i) {
      Piece& piece = pieces[i];
      take_corner_counts();  // of whatever the thread did before
      take_program_seconds();
      const double start = thread_seconds();
      plan[piece.set].work(piece.ids, piece.found);
      piece.found.seconds = thread_seconds() - start + take_program_seconds();
      piece.corners = take_corner_counts();
      progress.step();
    });
  }
  const std::size_t first = report.sets.size();
  for (const PlannedSet& set : plan) report.sets.push_back(set.report);
  CornerCounts corners{};
  for (const Piece& piece : pieces) {
    accumulate(report.sets[first + piece.set], piece.found);
    for (std::size_t corner = 0; corner < rtl::kCorners; ++corner) corners[corner] += piece.corners[corner];
  }
  if (std::none_of(plan.begin(), plan.end(), observes_corners)) return;
  for (std::size_t corner = 0; corner < rtl::kCorners; ++corner) {
    report.corners[std::string(rtl::kCornerNames[corner])] += corners[corner];
  }
}

Report regress(const RegressionOptions& options) {
  Report report;
  report.command = "regress";
  report.suite = options.suite;
  report.seed = options.seed;
  report.shard = options.shard;
  report.bins_must_be_hit = options.suite == "full" && !options.restricted();
  run_plan(make_plan(options), options, report);
  return report;
}

}  // namespace cbvh::testbench
