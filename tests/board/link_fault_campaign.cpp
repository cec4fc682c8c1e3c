// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Runs of the host's session over libusb against an emulated board that misbehaves. Every run must end, and end
// complete and right or with an error. Exit code 0 when all did.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "fpga/emulator/usb/preload.h"
#include "tests/board/faulted_run.h"
#include "vectors/random.h"

namespace {

using namespace cbvh;
using testing::Ending;

constexpr std::chrono::seconds kHung{60};  ///< far above the sum of all timeouts that a run can meet
constexpr std::size_t kSingleKinds = emulator::kFaultNames.size();
/// Behind the single kinds: several of them in each run, none at all, wrong answers, wrong answers and all kinds.
enum Mixed : std::size_t { kAll = kSingleKinds, kNone, kWrong, kWrongAndAll, kRows };

std::string row_name(std::size_t row) {
  if (row < kSingleKinds) return std::string(emulator::kFaultNames[row]);
  constexpr std::array kNames = {"all kinds", "none", "wrong answers", "wrong answers, all kinds"};
  return kNames[row - kSingleKinds];
}

struct Tally {
  std::uint64_t runs = 0;
  std::uint64_t faults = 0;
  std::uint64_t completed = 0;
  std::uint64_t failed = 0;
  std::uint64_t wrong = 0;
};
using Tallies = std::array<Tally, kRows>;

/// Ends the process when a run does not end: it could not go on.
class Watchdog {
 public:
  Watchdog() : thread_([this] { watch(); }) {}
  ~Watchdog() {
    set("");
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// A run begins; empty: there will be none.
  void set(const std::string& run) {
    const std::lock_guard lock(mutex_);
    run_ = run;
    ++number_;
    changed_.notify_all();
  }

 private:
  void watch() {
    std::unique_lock lock(mutex_);
    while (!run_.empty()) {
      const std::uint64_t number = number_;
      if (changed_.wait_for(lock, kHung, [&] { return number_ != number; })) continue;
      fmt::print(stderr, "HUNG after {} s: {}\n", kHung.count(), run_);
      _exit(1);
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string run_ = "the first";
  std::uint64_t number_ = 0;
  std::thread thread_;
};

testing::Ordeal make_ordeal(std::size_t row, std::uint64_t seed) {
  vectors::Random random(seed);
  testing::Ordeal ordeal;
  ordeal.seed = seed;
  ordeal.transport = static_cast<emulator::Transport>(random.below(3));
  ordeal.wrong_answers = row == kWrong || row == kWrongAndAll;
  const auto rate = [&random] { return std::ldexp(0.01, random.between(0, 4)); };
  if (row < kSingleKinds) ordeal.faults = {{static_cast<emulator::FaultKind>(row), rate()}};
  if (row == kAll || row == kWrongAndAll) {
    for (std::size_t kind = 0; kind < kSingleKinds; ++kind) {
      if (random.flip()) ordeal.faults.push_back({static_cast<emulator::FaultKind>(kind), rate() / 4});
    }
  }
  return ordeal;
}

std::size_t open_files() {
  const auto files = std::filesystem::directory_iterator("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

std::size_t threads() {
  const auto tasks = std::filesystem::directory_iterator("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

/// Whether there are no more than so many open files and threads; what ends on its own gets a moment to do so.
bool settles(std::size_t files, std::size_t tasks) {
  constexpr int kTries = 200;
  constexpr std::chrono::milliseconds kMoment{10};
  for (int i = 0; i < kTries; ++i) {
    if (open_files() <= files && threads() <= tasks) return true;
    std::this_thread::sleep_for(kMoment);
  }
  return false;
}

/// Runs `first`, `first + step`, ... below `runs`.
Tallies run_share(std::uint64_t first, std::uint64_t step, std::uint64_t runs, std::uint64_t seed, bool verbose) {
  Tallies tallies;
  emulator::UsbSystem system;
  Watchdog watchdog;
  std::size_t files_before = 0;
  std::size_t threads_before = 0;
  for (std::uint64_t i = first; i < runs; i += step) {
    const std::size_t row = i % kRows;
    const testing::Ordeal ordeal = make_ordeal(row, vectors::mix(seed, i));
    const std::string name = fmt::format("run {} ({}, {})", i, row_name(row), to_string(ordeal.transport));
    watchdog.set(name);
    const testing::RunReport report = run_ordeal(system, ordeal);
    Tally& tally = tallies[row];
    ++tally.runs;
    tally.faults += report.faults;
    ++(report.ending == Ending::completed ? tally.completed
       : report.ending == Ending::failed  ? tally.failed
                                          : tally.wrong);
    if (verbose || report.ending == Ending::wrong) {
      const char* const ending = report.ending == Ending::wrong    ? "WRONG"
                                 : report.ending == Ending::failed ? "failed"
                                                                   : "completed";
      fmt::print(stderr, "{}: {} after {} faults: {}\n", name, ending, report.faults, report.what);
    }
    if (i == first) {  // what lives as long as the process is there from now on
      files_before = open_files();
      threads_before = threads();
    } else if (!settles(files_before, threads_before)) {
      fmt::print(stderr, "{}: LEAK: {} open files, {} threads, after the first run {} and {}\n", name, open_files(),
                 threads(), files_before, threads_before);
      ++tally.wrong;
      files_before = open_files();
      threads_before = threads();
    }
  }
  return tallies;
}

/// Several processes, as a run waits for most of its time. False when one of them has ended before its time.
bool run_shares(std::uint64_t jobs, std::uint64_t runs, std::uint64_t seed, bool verbose, Tallies& sum) {
  std::vector<std::pair<pid_t, int>> children;
  for (std::uint64_t job = 0; job < jobs; ++job) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return false;
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      const Tallies tallies = run_share(job, jobs, runs, seed, verbose);
      if (write(ends[1], &tallies, sizeof tallies) != sizeof tallies) std::exit(1);
      std::exit(0);  // not _exit: leaks are looked for
    }
    close(ends[1]);
    children.emplace_back(child, ends[0]);
  }
  bool good = true;
  for (const auto& [child, end] : children) {
    Tallies tallies;
    good = read(end, &tallies, sizeof tallies) == sizeof tallies && good;
    close(end);
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) fmt::print(stderr, "a process of the campaign ended with status {}\n", status);
    good = good && status == 0;
    for (std::size_t row = 0; good && row < kRows; ++row) {
      sum[row].runs += tallies[row].runs;
      sum[row].faults += tallies[row].faults;
      sum[row].completed += tallies[row].completed;
      sum[row].failed += tallies[row].failed;
      sum[row].wrong += tallies[row].wrong;
    }
  }
  return good;
}

/// A kind of fault that never happened has not been tried. A board that stays can be spoken to in most runs.
bool print_table(const Tallies& tallies, std::uint64_t runs) {
  bool good = true;
  Tally all;
  const auto print = [](const std::string& name, const Tally& tally) {
    fmt::print("| {} | {} | {} | {} | {} | 0 | {} |\n", name, tally.runs, tally.faults, tally.completed, tally.failed,
               tally.wrong);
  };
  fmt::print("| fault | runs | faults | completed | failed cleanly | hung | wrong |\n|---|---|---|---|---|---|---|\n");
  for (std::size_t row = 0; row < kRows; ++row) {
    const Tally& tally = tallies[row];
    print(row_name(row), tally);
    good = good && tally.wrong == 0;
    const bool must_complete = row == kNone || row == kWrong;
    if (must_complete && tally.completed != tally.runs) good = false;
    if (!must_complete && tally.faults == 0 && tally.runs >= 10) good = false;
    all.runs += tally.runs;
    all.faults += tally.faults;
    all.completed += tally.completed;
    all.failed += tally.failed;
    all.wrong += tally.wrong;
  }
  print("all", all);
  return good && all.runs == runs && all.completed > 0 && all.faults > 0;
}

}  // namespace

int main(int argc, char** argv) {
  emulator::preload_umockdev(argv);
  std::uint64_t runs = 1000;
  std::uint64_t seed = 1;
  std::uint64_t jobs = 1;
  std::optional<std::uint64_t> only;
  bool verbose = false;
  CLI::App app("Runs the host's session against an emulated USB board that misbehaves.", "link_fault_campaign");
  app.add_option("--runs", runs, "how many")->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "of everything");
  app.add_option("--jobs", jobs, "processes")->check(CLI::PositiveNumber);
  app.add_option("--only", only, "one run, by its number");
  app.add_flag("--verbose", verbose, "print how each run ends");
  CLI11_PARSE(app, argc, argv);
  if (only) {
    const Tallies tallies = run_share(*only, 1, *only + 1, seed, true);
    return tallies[*only % kRows].wrong == 0 ? 0 : 1;
  }
  Tallies tallies;
  if (!run_shares(jobs, runs, seed, verbose, tallies)) return 1;
  return print_table(tallies, runs) ? 0 : 1;
}
