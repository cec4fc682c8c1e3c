// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/backtrack_steps.h"

#include <algorithm>

#include "vectors/faces/collector.h"
#include "vectors/generate/float_trees.h"
#include "vectors/generate/streams.h"

namespace cbvh::vectors {
namespace {

using Context = golden::Context<Index>;
using Steps = std::vector<PlainBacktrackStep>;
enum Class : std::size_t {
  kLeafPair,
  kStopsAtOnce,
  kBothChildren,
  kLeftSpine,
  kRightSpine,
  kRandomShape,
  kScattered,
  kFullSpan,
  kIdentical,
  kPlanar,
  kLowerOnly,
  kOneAxis,
  kNoChange,
  kFarCoarser,
  kTwoJobs,
  kFromStream
};

/// A compressed tree in memory, and the box and context of its root.
struct Stored {
  Steps steps;
  golden::Box box;
  std::uint32_t root;
  Context context;
  rtl::SceneRegisters registers;
};

Stored store(const std::vector<rtl::StreamJob>& jobs, int bits) {
  constexpr int kAllLevels = 64;  // one treelet: compressed top-down
  Stored stored;
  for (const FinalAnswer& answer : collect(jobs, kAllLevels, bits)) {
    stored.steps.push_back({false, answer.index, answer.pair, {}, {}, {}});
    if (answer.last) stored.context = answer.root;
  }
  stored.box = union_box(jobs.back().pair);
  stored.root = static_cast<std::uint32_t>(jobs.size() - 1);
  stored.registers = jobs.back().registers;
  return stored;
}

Stored store_tree(TreeShape shape, TreePlaces places, int levels, Random& random, int bits) {
  const rtl::SceneRegisters registers{rtl::Scale(-149), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
  std::vector<rtl::StreamJob> jobs = random_tree(shape, places, levels, random).finish(registers);
  if (random.one_in(4)) {  // own grids that saturate
    const int coarser = random.between(1, 10);
    for (rtl::StreamJob& job : jobs) job.registers.min_scale = rtl::Scale(job.registers.min_scale.value() + coarser);
  }
  return store(jobs, bits);
}

enum class Shift : std::uint8_t { none, any, all };

/// The context in which the root's box lies on a grid `gap` binary orders coarser, shifted by up to the room there is.
golden::AxisContext<Index> coarser(const Stored& stored, std::size_t axis, int gap, Shift shift, Random& random,
                                   int bits) {
  const int component = static_cast<int>(axis);
  const int scale = std::min(128, stored.context[axis].scale + gap);
  const Cells<Index> cells = golden::encode<Index>(stored.box.lower[component], stored.box.upper[component], scale);
  const Index room = rules_of(stored.registers, bits).max_cells() - (cells.upper - cells.lower);
  Index offset = 0;
  if (shift == Shift::all) offset = room;
  if (shift == Shift::any) offset = static_cast<Index>(random.below(static_cast<std::uint64_t>(room) + 1));
  return {scale, cells.lower - offset};
}

Shift any_shift(Random& random) { return static_cast<Shift>(random.below(3)); }

/// What a job's contexts change by.
Context changed(const Stored& stored, std::size_t case_class, Random& random, int bits) {
  Context after = stored.context;
  const std::size_t chosen = random.below(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Shift shift = case_class == kFullSpan ? Shift::all : any_shift(random);
    int gap = random.between(0, 4);
    if (case_class == kLeftSpine || case_class == kRightSpine) gap = random.between(0, 24);
    if (case_class == kFarCoarser) gap = random.between(8, 24);
    if (case_class == kStopsAtOnce) gap = 1;
    if (case_class == kLowerOnly) gap = 0;
    if (case_class == kNoChange || (case_class == kOneAxis && axis != chosen)) continue;
    after[axis] = coarser(stored, axis, gap, shift, random, bits);
  }
  return after;
}

Stored stored_of_class(std::size_t case_class, Random& random, int bits) {
  switch (case_class) {
    case kLeafPair:
      return store_tree(TreeShape::single_pair, TreePlaces::halved, 1, random, bits);
    case kStopsAtOnce:
      return store_tree(TreeShape::balanced, TreePlaces::halved, 2, random, bits);
    case kBothChildren:
      return store_tree(TreeShape::balanced, TreePlaces::halved, random.between(2, 4), random, bits);
    case kLeftSpine:
      return store_tree(TreeShape::left_spine, TreePlaces::halved, random.between(2, 31), random, bits);
    case kRightSpine:
      return store_tree(TreeShape::right_spine, TreePlaces::halved, random.between(2, 31), random, bits);
    case kScattered:
      return store_tree(TreeShape::random, TreePlaces::scattered, random.between(3, 7), random, bits);
    case kFullSpan:
      return store_tree(TreeShape::balanced, TreePlaces::full_span, random.between(2, 4), random, bits);
    case kIdentical:
      return store_tree(TreeShape::random, TreePlaces::identical, random.between(2, 6), random, bits);
    case kPlanar:
      return store_tree(TreeShape::random, TreePlaces::planar, random.between(2, 7), random, bits);
    default:
      return store_tree(TreeShape::random, TreePlaces::halved, random.between(3, 7), random, bits);
  }
}

void add_job(Steps& steps, const Stored& stored, const Context& before, const Context& after) {
  steps.push_back({true, stored.root, {}, before, after, stored.registers});
}

}  // namespace

std::vector<PlainBacktrackStep> backtrack_steps_of(std::span<const rtl::StreamJob> jobs, int levels, int bits) {
  Steps steps;
  for (const FinalAnswer& answer : collect(jobs, levels, bits)) {
    if (answer.status != rtl::Status::ok) continue;
    steps.push_back({false, answer.index, answer.pair, {}, {}, {}});
    for (std::size_t c = 0; c < 2; ++c) {
      if (!answer.repair[c]) continue;
      steps.push_back({true, answer.pair.child[c].pointer, {}, answer.before[c], answer.after[c], answer.registers});
    }
  }
  return steps;
}

std::vector<PlainBacktrackStep> make_backtrack_steps(std::size_t case_class, Random& random, int bits) {
  if (case_class == kFromStream) {
    for (int attempt = 0; attempt < 8; ++attempt) {  // most streams repair something
      const std::vector<rtl::StreamJob> stream = make_valid_stream(random);
      Steps steps = backtrack_steps_of(stream, random.between(1, 3), bits);
      if (std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.repair; })) return steps;
    }
  }
  Stored stored = stored_of_class(case_class, random, bits);
  Steps steps = stored.steps;
  const Context after = changed(stored, case_class, random, bits);
  add_job(steps, stored, stored.context, after);
  if (case_class == kTwoJobs) {
    stored.context = after;
    add_job(steps, stored, after, changed(stored, kRandomShape, random, bits));
  }
  return steps;
}

}  // namespace cbvh::vectors
