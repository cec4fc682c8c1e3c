// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/ray_episodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/update/top_down.h"
#include "vectors/generate/float_trees.h"
#include "vectors/generate/floats.h"
#include "vectors/generate/ray_setup_jobs.h"
#include "vectors/ray_tree.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSingleLeaf,
  kSinglePair,
  kLeftSpine,
  kRightSpine,
  kBalanced,
  kRandomShape,
  kBigLeaves,
  kSameBoxes,
  kPlanar,
  kPoints,
  kFullSpan,
  kAxisParallel,
  kOriginInside,
  kStops,
  kDeepStack,
  kRefused
};

/// Every level leaves a leaf behind that starts where the next one does: more than the stack holds.
std::vector<rtl::StreamJob> deep_tree(const rtl::SceneRegisters& registers, Random& random) {
  TreeEmitter emit;
  const golden::Box box{glm::vec3(-1), glm::vec3(random.unit())};
  TreeNode node = emit.leaf(box);
  for (int level = random.between(30, 38); level > 0; --level) {
    const TreeNode right = emit.leaf(box);
    node = emit.pair(node, right);
  }
  return emit.finish(registers);
}

std::vector<rtl::StreamJob> jobs_of(std::size_t case_class, Random& random) {
  const bool figure5 = random.flip();
  const rtl::SceneRegisters registers{rtl::Scale(-149), rtl::UInt<1>(figure5), rtl::UInt<1>(random.flip())};
  if (case_class == kDeepStack) return deep_tree(registers, random);
  constexpr TreeShape kShapes[] = {TreeShape::single_pair, TreeShape::left_spine, TreeShape::right_spine,
                                   TreeShape::balanced, TreeShape::random};
  const bool shaped = case_class >= kSinglePair && case_class <= kRandomShape;
  const TreeShape shape = kShapes[shaped ? case_class - kSinglePair : 1 + random.below(4)];
  TreePlaces places = random.flip() ? TreePlaces::scattered : TreePlaces::halved;
  if (random.one_in(6)) places = TreePlaces::negative;
  if (case_class == kSameBoxes) places = TreePlaces::identical;
  if (case_class == kPlanar) places = TreePlaces::planar;
  if (case_class == kPoints) places = TreePlaces::points;
  if (case_class == kFullSpan) places = TreePlaces::full_span;
  const int levels = shape == TreeShape::balanced ? random.between(2, 4) : random.between(2, 9);
  return random_tree(shape, places, shape == TreeShape::single_pair ? 1 : levels, random).finish(registers);
}

/// Leaves of some primitives each, numbered in another order than they lie.
void fill_leaves(golden::FloatTree& tree, bool big, bool single, Random& random) {
  std::vector<std::uint32_t> first(tree.pairs.size() + 1);
  for (std::uint32_t& begin : first) {
    begin = static_cast<std::uint32_t>(tree.primitive_ids.size());
    const int count = big ? random.between(1, 40) : random.one_in(4) ? random.between(1, 4) : 1;
    for (int i = 0; i < count; ++i) tree.primitive_ids.push_back(0);
    tree.primitive_ids.back() = golden::kLastOfLeaf;
    if (single) break;
  }
  const auto count = static_cast<std::uint32_t>(tree.primitive_ids.size());
  for (std::uint32_t i = 0; i < count; ++i) tree.primitive_ids[i] |= count - 1 - i;
  for (golden::FloatPair& pair : tree.pairs) {
    for (std::size_t c = 0; c < 2; ++c) {
      if (pair.leaf[c]) pair.pointer[c] = first[pair.pointer[c]];
    }
  }
  tree.primitives = count;
}

golden::CompressedTree compressed(std::size_t case_class, Random& random, int bits) {
  const std::vector<rtl::StreamJob> jobs = jobs_of(case_class, random);
  golden::FloatTree tree;
  for (const rtl::StreamJob& job : jobs) {
    golden::FloatPair& pair = tree.pairs.emplace_back();
    for (std::size_t c = 0; c < 2; ++c) {
      pair.child[c] = plain_box(job.pair.box[c]);
      pair.leaf[c] = bool(job.pair.leaf[c]);
      pair.pointer[c] = static_cast<std::uint32_t>(job.pair.pointer[c].raw());
      tree.largest_magnitude = std::max(tree.largest_magnitude, golden::largest_magnitude(pair.child[c]));
    }
  }
  const bool single = case_class == kSingleLeaf;
  tree.scene = single ? tree.pairs[0].child[0] : golden::own_box(tree.pairs.back());
  if (single) tree.pairs.clear();
  fill_leaves(tree, case_class == kBigLeaves, single, random);
  tree.leaves = static_cast<std::uint32_t>(tree.pairs.size() + 1);
  const rtl::SceneRegisters& registers = jobs.back().registers;
  return golden::compress_top_down(tree, rules_of(registers, bits), code_of(registers));
}

std::size_t ray_class(std::size_t case_class, Random& random) {
  const auto named = [](std::string_view name) {
    return static_cast<std::size_t>(std::find(kRaySetupClasses.begin(), kRaySetupClasses.end(), name) -
                                    kRaySetupClasses.begin());
  };
  if (case_class == kAxisParallel) return named(random.one_in(6) ? "all-parallel" : "axis-parallel");
  if (case_class == kOriginInside) return named("origin-inside");
  if (random.flip()) return named(random.flip() ? "towards-box" : "backwards");
  return random.below(kValidRays);
}

void aim_at(const RootCells& root, std::size_t case_class, rtl::RaySetupJob& job, Random& random) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.root.lower[axis] = rtl::Float32::of(root.edges[axis].near);
    job.root.upper[axis] = rtl::Float32::of(root.edges[axis].far);
  }
  aim(ray_class(case_class, random), job, random);
}

rtl::RayJob make_ray(const RootCells& root, std::size_t case_class, std::size_t number, Random& random) {
  rtl::RaySetupJob aimed;
  aim_at(root, case_class, aimed, random);
  rtl::RayJob ray;
  ray.number = rtl::UInt<32>(number * 3 + 1);
  ray.origin = aimed.origin;
  ray.direction = aimed.direction;
  ray.t_min = rtl::Float32::of(random.one_in(4) ? float_within(1, random) : any_zero(random));
  const float end = random.one_in(4) ? random.unit() * 2 : std::numeric_limits<float>::infinity();
  ray.t_max = rtl::Float32::of(end);
  return ray;
}

/// Some of the candidates of a ray that hits nothing become hits.
void add_hits(RayEpisode& episode, const rtl::RayJob& ray, bool stops, Random& random, int bits) {
  std::vector<PlainCandidate> met;
  const PlainRayTree tree = plain_ray_tree(episode.tree);
  traverse(
      plain_ray(ray), tree, bits, [&](const PlainCandidate& candidate) { met.push_back(candidate); },
      [] { return PlainReply(); });
  const std::uint64_t often = 1 + random.below(6);
  for (const PlainCandidate& candidate : met) {
    if (random.below(often) != 0) continue;
    const float beyond = std::fabs(candidate.entry) * random.unit();
    const float t = candidate.entry + (random.flip() ? beyond : 0);
    if (std::isnan(t)) continue;
    episode.hits.push_back(
        {ray.number, rtl::Pointer(candidate.primitive), rtl::Float32::of(t), rtl::UInt<1>(stops && random.flip())});
  }
}

void refuse(RayEpisode& episode, Random& random) {
  if (random.flip()) {
    rtl::RayJob& ray = episode.rays[random.below(episode.rays.size())];
    const float special = any_special_float(random);
    const std::size_t axis = random.below(3);
    const std::uint64_t where = random.below(3);
    if (where == 0) ray.origin[axis] = rtl::Float32::of(special);
    if (where == 1) ray.direction[axis] = rtl::Float32::of(special);
    if (where == 2) ray.t_max = rtl::Float32::of_raw(0x7FC00000);
    return;
  }
  golden::CompressedPair& pair = episode.tree.pairs[random.below(episode.tree.pairs.size())];
  golden::AxisCodes& codes = pair.child[random.below(2)].codes[random.below(3)];
  if (random.flip()) {
    codes.upper = codes.lower;
  } else {
    std::swap(codes.upper, codes.lower);
  }
}

}  // namespace

RayEpisode make_ray_episode(std::size_t case_class, Random& random, int bits) {
  RayEpisode episode;
  episode.tree = compressed(case_class, random, bits);
  const RootCells root = root_cells(episode.tree);
  const int rays = random.between(1, 10);
  for (int i = 0; i < rays; ++i) {
    episode.rays.push_back(make_ray(root, case_class, static_cast<std::size_t>(i), random));
  }
  if (case_class == kRefused) refuse(episode, random);
  for (const rtl::RayJob& ray : episode.rays) {
    if (random.flip()) add_hits(episode, ray, case_class == kStops, random, bits);
  }
  return episode;
}

}  // namespace cbvh::vectors
