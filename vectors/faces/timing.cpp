// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/timing.h"

#include <algorithm>

#include "vectors/faces/backtrack.h"

namespace cbvh::vectors {
namespace {

constexpr std::uint32_t kPairCompressorCycles = 6;

/// Room in the output queue: eight rows, and no less than 64 pairs.
std::size_t queue_capacity(int levels) { return std::max<std::size_t>(64, std::size_t{8} << levels); }

/// Final pairs that one job can make: a row of the last level; a whole treelet when the root flushes it.
std::size_t most_finals(bool root, int levels) {
  return root ? (std::size_t{1} << levels) - 1 : std::size_t{1} << (levels - 1);
}

/// Of each job the places in the queue that its shape takes along and a refusal of its tree leaves empty.
std::vector<std::size_t> unused_places(std::span<const rtl::StreamJob> jobs, std::span<const FinalAnswer> finals,
                                       int levels, int bits) {
  std::vector<std::size_t> places(jobs.size());
  if (std::all_of(finals.begin(), finals.end(), [](const auto& answer) { return answer.status == rtl::Status::ok; })) {
    return places;
  }
  std::vector<rtl::StreamJob> shape(jobs.begin(), jobs.end());
  for (rtl::StreamJob& job : shape) {
    job.pair.box = {};
    job.registers = {};
  }
  for (const FinalAnswer& answer : collect(shape, levels, bits)) ++places[answer.arrival];
  for (const FinalAnswer& answer : finals) --places[answer.arrival];
  return places;
}

}  // namespace

std::vector<std::uint32_t> on_chip_repairs(std::span<const rtl::StreamJob> jobs, int levels, int bits) {
  std::vector<std::uint32_t> repairs(jobs.size());
  BacktrackMemory memory(bits);
  for (const FinalAnswer& answer : collect(jobs, 1, bits)) {
    if (answer.status == rtl::Status::ok) {
      memory.write(answer.index, answer.pair);
      for (std::size_t c = 0; c < 2; ++c) {
        if (!answer.repair[c]) continue;
        const auto written =
            memory.repair(answer.pair.child[c].pointer, answer.before[c], answer.after[c], answer.registers);
        repairs[answer.arrival] += static_cast<std::uint32_t>(
            std::count_if(written.begin(), written.end(), [&](const auto& pair) { return pair.level < levels; }));
      }
    }
    if (answer.last) memory.clear();
  }
  return repairs;
}

std::vector<std::uint32_t> collector_cycles(std::span<const rtl::StreamJob> jobs, std::span<const FinalAnswer> finals,
                                            const CollectorTiming& timing, int bits) {
  const auto repairs =
      timing.lazy ? on_chip_repairs(jobs, timing.levels, bits) : std::vector<std::uint32_t>(jobs.size());
  const std::uint32_t depth =
      timing.lazy ? kPairCompressorCycles : kPairCompressorCycles * static_cast<unsigned>(timing.levels);
  const auto unused =
      timing.lazy ? std::vector<std::size_t>(jobs.size()) : unused_places(jobs, finals, timing.levels, bits);
  std::vector<std::uint32_t> leaves_queue;  // of each final pair so far
  std::vector<std::uint32_t> frees_place;   // of each place taken so far, in ascending order
  std::uint32_t accepted = 0;
  std::uint32_t ready = 0;  // cycle in which the newest job's final pairs may leave the queue
  std::size_t next = 0;
  for (std::size_t job = 0; job < jobs.size(); ++job) {
    if (job > 0) ++accepted;
    if (ready > depth) accepted = std::max(accepted, ready - depth);  // a re-encoder still at work holds the compressor
    // The job waits until so many pairs have left that its own fit in any case.
    const std::size_t most = most_finals(bool(jobs[job].root), timing.levels);
    const std::size_t capacity = queue_capacity(timing.levels);
    if (frees_place.size() + most > capacity) {
      accepted = std::max(accepted, frees_place[frees_place.size() + most - capacity - 1]);
    }
    ready = std::max(ready, accepted + depth) + repairs[job];
    frees_place.insert(std::upper_bound(frees_place.begin(), frees_place.end(), ready), unused[job], ready);
    for (; next < finals.size() && finals[next].arrival == job; ++next) {
      leaves_queue.push_back(leaves_queue.empty() ? ready : std::max(ready, leaves_queue.back() + 1));
      frees_place.push_back(leaves_queue.back());
    }
  }
  for (std::uint32_t& cycle : leaves_queue) ++cycle;  // seen one cycle after it left
  return leaves_queue;
}

}  // namespace cbvh::vectors
