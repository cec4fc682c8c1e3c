// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// fault_campaign [--jobs N] [--only FAULT] LIST|--all: puts one deliberate fault after the other into the C++ modules
// and asks the smoke regression whether it notices. LIST is a file of fault names, one a line, with # comments. --all
// takes every operator of every datapath, its lowest and its highest bit, and every decision. Prints who caught what; a
// fault of LIST that nobody notices fails the campaign, of
// --all it is listed: some faults change nothing that can be seen. Each fault has a process of its own, limited in
// memory and time.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "testbench/regression/regress.h"
#include "tests/faults/faulty_bits.h"

namespace cbvh::testing {
namespace {

using testbench::PlannedSet;
using testbench::RegressionOptions;
using testbench::Report;

constexpr rlim_t kMemory = rlim_t{4} << 30;
constexpr rlim_t kSeconds = 60;

/// The units whose sets are asked first: those the faulty part is closest to.
std::vector<std::string> nearest_units(const Fault& fault) {
  if (fault.kind == Fault::Kind::decision)
    return {"context_stack",      "backtrack_unit",      "lazy_treelet_collector",
            "stream_compressor",  "run_sorter",          "hierarchy_emitter",
            "run_merger",         "node_writer",         "refit_walker",
            "primitive_gatherer", "top_down_compressor", "traversal_unit"};
  switch (fault.datapath) {
    case rtl::Datapath::compress_axis:
      return {"axis_compressor"};
    case rtl::Datapath::estimate_scale:
      return {"scale_estimator"};
    case rtl::Datapath::primitive_box:
      return {"box_builder"};
    case rtl::Datapath::morton_frame:
    case rtl::Datapath::morton_code:
      return {"morton_encoder"};
    case rtl::Datapath::unite_boxes:
      return {"hierarchy_emitter", "refit_walker"};
    case rtl::Datapath::common_prefix:
      return {"hierarchy_emitter"};
    case rtl::Datapath::merge_compare:
      return {"run_merger"};
    case rtl::Datapath::decode_box:
      return {"box_decoder"};
    case rtl::Datapath::ray_setup:
      return {"ray_setter"};
    case rtl::Datapath::intersect_pair:
      return {"pair_intersector"};
    case rtl::Datapath::reencode:
    case rtl::Datapath::invalidates:
      return {"backtrack_unit", "treelet_collector"};
    default:
      return {"node_pair_compressor"};
  }
}

/// The first check of these sets that fails, or nothing.
std::string first_failure(const std::vector<PlannedSet>& plan, const RegressionOptions& options) {
  for (const PlannedSet& set : plan) {
    Report report;
    testbench::run_plan({set}, options, report);
    const auto& found = report.sets.front();
    if (found.failures == 0) continue;
    if (found.mismatches.empty()) return fmt::format("{}, {}, {}", found.unit, found.set, found.mode);
    const auto& mismatch = found.mismatches.front();
    return fmt::format("{}, {}, {}: {} of class {}", found.unit, found.set, found.mode, mismatch.field,
                       mismatch.case_class);
  }
  return {};
}

/// The check of `cbvh regress --suite smoke` that notices the fault, or nothing.
std::string ask_regression(const Fault& fault) {
  RegressionOptions options;
  options.suite = "smoke";
  options.threads = 1;
  active_fault = fault;
  options.units = nearest_units(fault);
  std::string caught = first_failure(testbench::make_plan(options), options);
  if (caught.empty()) {
    options.units.clear();
    caught = first_failure(testbench::make_plan(options), options);
  }
  return caught;
}

/// A fault under test in a child process, and where it says who caught it.
struct Trial {
  Fault fault;
  int answer = -1;
};

std::map<pid_t, Trial> running;

void start(const Fault& fault) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("pipe");
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) {
    close(ends[0]);
    const rlimit memory{kMemory, kMemory};
    const rlimit seconds{kSeconds, kSeconds};
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CPU, &seconds);
    std::freopen("/dev/null", "w", stderr);
    std::string caught;
    try {
      caught = ask_regression(fault);
    } catch (const std::exception& error) {
      caught = fmt::format("the run ended with an exception: {}", error.what());
    }
    const auto written = write(ends[1], caught.data(), caught.size());
    _exit(written == static_cast<ssize_t>(caught.size()) ? 0 : 3);
  }
  close(ends[1]);
  running[child] = {fault, ends[0]};
}

struct Tally {
  int caught = 0;
  int survived = 0;
};

void finish_one(Tally& tally) {
  int status = 0;
  const pid_t child = wait(&status);
  const Trial trial = running.at(child);
  running.erase(child);
  std::string caught;
  std::array<char, 512> buffer{};
  for (ssize_t got = 0; (got = read(trial.answer, buffer.data(), buffer.size())) > 0;)
    caught.append(buffer.data(), static_cast<std::size_t>(got));
  close(trial.answer);
  if (WIFSIGNALED(status)) caught = fmt::format("the run was ended by signal {}", WTERMSIG(status));
  ++(caught.empty() ? tally.survived : tally.caught);
  std::cout << fmt::format("{:<10} {:<32} {}\n", caught.empty() ? "SURVIVED" : "caught", trial.fault.name(), caught);
}

std::vector<Fault> read_list(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  std::vector<Fault> faults;
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find('#'));
    line.erase(line.find_last_not_of(" \t") + 1);
    if (!line.empty()) faults.push_back(Fault::parse(line));
  }
  return faults;
}

/// Every operator that a fault-free regression evaluates, with its lowest and its highest bit, and every decision.
std::vector<Fault> all_faults() {
  RegressionOptions options;
  options.threads = 1;
  options.stalls = {"none"};
  const std::string wrong = first_failure(testbench::make_plan(options), options);
  if (!wrong.empty()) throw std::runtime_error("fails without a fault: " + wrong);
  constexpr std::uint32_t kHighest = 63;
  std::vector<Fault> faults;
  for (std::size_t datapath = 0; datapath < rtl::kDatapaths; ++datapath) {
    for (std::uint32_t site = 0; site < operators_seen[datapath]; ++site) {
      for (const std::uint32_t bit : {0U, kHighest}) {
        faults.push_back({Fault::Kind::operator_result, static_cast<rtl::Datapath>(datapath), site, bit, {}});
      }
    }
  }
  for (const auto corner : control_decisions()) faults.push_back({Fault::Kind::decision, {}, 0, 0, corner});
  return faults;
}

int run(int argc, char** argv) {
  std::size_t jobs = 1;
  std::vector<Fault> faults;
  bool all = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--jobs" && i + 1 < argc) {
      jobs = std::stoul(argv[++i]);
    } else if (argument == "--only" && i + 1 < argc) {
      faults = {Fault::parse(argv[++i])};
    } else if (argument == "--all") {
      all = true;
      faults = all_faults();
    } else {
      faults = read_list(argument);
    }
  }
  if (faults.empty()) throw std::runtime_error("no faults given");
  Tally tally;
  for (const Fault& fault : faults) {
    if (running.size() >= jobs) finish_one(tally);
    start(fault);
  }
  while (!running.empty()) finish_one(tally);
  std::cout << fmt::format("{} faults: {} caught, {} survived\n", faults.size(), tally.caught, tally.survived);
  if (!all) std::cout << fmt::format("{} passed, {} failed\n", tally.caught, tally.survived);
  return all || tally.survived == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace cbvh::testing

int main(int argc, char** argv) {
  try {
    return cbvh::testing::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fault_campaign: " << error.what() << '\n';
    return 2;
  }
}
