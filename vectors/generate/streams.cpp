// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/streams.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "golden/build/lbvh.h"
#include "golden/quantize/quantize.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "vectors/generate/float_trees.h"

namespace cbvh::vectors {
namespace {

using Stream = std::vector<rtl::StreamJob>;
enum Class : std::size_t {
  kSinglePair,
  kLeftSpine,
  kRightSpine,
  kPending,
  kBalanced,
  kRandomShape,
  kScattered,
  kIdentical,
  kPlanar,
  kPoints,
  kFullSpan,
  kNegative,
  kCoarseMinimum,
  kTroubleScene,
  kProceduralScene,
  kNotFinite,
  kInverted,
  kBeyondExactness,
  kRefusedRoot,
  kTooDeep,
  kTwoTrees,
  kRefusedThenValid,
  kSmallTrees
};
static_assert(kNotFinite == kValidStreamClasses);

constexpr int kFinest = -149;

rtl::SceneRegisters any_registers(Random& random, int min_scale = kFinest) {
  return {rtl::Scale(min_scale), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
}

TreePlaces any_places(Random& random) { return static_cast<TreePlaces>(random.below(7)); }

Stream tree(TreeShape shape, TreePlaces places, int levels, Random& random) {
  const rtl::SceneRegisters registers = any_registers(random);
  return random_tree(shape, places, levels, random).finish(registers);
}

Stream built(const golden::Mesh& mesh, Random& random) {
  const golden::FloatTree floats = golden::build_lbvh(mesh);
  return stream_of(floats, any_registers(random, golden::exactness_limit(floats.largest_magnitude)));
}

Stream trouble_tree(Random& random) {
  for (;;) {  // a scene that is one leaf has no pairs
    const golden::Trouble trouble = golden::kTroubles[random.below(golden::kTroubles.size() - 1)];
    const std::uint64_t seed = random.next();
    Stream stream = built(golden::trouble_scene(trouble, seed, random.between(2, 24)), random);
    if (!stream.empty()) return stream;
  }
}

Stream procedural_tree(Random& random) {
  const std::uint64_t seed = random.below(1000);
  const std::string specs[] = {fmt::format("proc:soup,triangles={},seed={}", random.between(8, 24), seed),
                               fmt::format("proc:terrain,triangles={},seed={}", random.between(8, 24), seed),
                               "proc:cloth,sheet=2,height=2"};
  return built(golden::load_scene(specs[random.below(3)]), random);
}

/// Spoils a box of the pair; the registers of the whole tree where that is the reason.
void refuse(Stream& stream, std::size_t index, std::size_t reason, Random& random) {
  rtl::FloatBox& box = stream[index].pair.box[random.below(2)];
  const std::size_t axis = random.below(3);
  rtl::Float32& lower = box.lower[axis];
  rtl::Float32& upper = box.upper[axis];
  if (reason == kNotFinite) {
    constexpr std::uint32_t kSpecials[] = {0x7F800000, 0xFF800000, 0x7FC00000, 0xFF800001};
    const rtl::Float32 special{kSpecials[random.below(4)]};
    (random.flip() ? lower : upper) = special;
  } else if (reason == kInverted) {
    upper = lower;
    lower = rtl::Float32::of(std::nextafter(upper.value(), std::numeric_limits<float>::max()));
  } else {  // a coordinate with a coarser last place than the rest
    const int exponent = static_cast<int>(stream[0].registers.min_scale.value()) + 24;
    upper = rtl::Float32::of(std::ldexp(1.0F, std::min(exponent, 127)));
  }
}

Stream valid_tree(std::size_t case_class, Random& random) {
  const TreePlaces places = any_places(random);
  switch (case_class) {
    case kSinglePair:
      return tree(TreeShape::single_pair, places, 1, random);
    case kLeftSpine:
      return tree(TreeShape::left_spine, places, random.between(2, 31), random);
    case kRightSpine:
      return tree(TreeShape::right_spine, places, random.between(2, 31), random);
    case kPending:
      return tree(TreeShape::pending_spine, places, random.between(2, 31), random);
    case kBalanced:
      return tree(TreeShape::balanced, TreePlaces::halved, random.between(2, 5), random);
    case kRandomShape:
      return tree(TreeShape::random, TreePlaces::halved, random.between(4, 9), random);
    case kScattered:
      return tree(TreeShape::random, TreePlaces::scattered, random.between(4, 8), random);
    case kIdentical:
      return tree(TreeShape::random, TreePlaces::identical, random.between(3, 7), random);
    case kPlanar:
      return tree(TreeShape::random, TreePlaces::planar, random.between(3, 8), random);
    case kPoints:
      return tree(TreeShape::random, TreePlaces::points, random.between(3, 8), random);
    case kFullSpan:
      return tree(TreeShape::balanced, TreePlaces::full_span, random.between(2, 5), random);
    case kNegative:
      return tree(TreeShape::random, TreePlaces::negative, random.between(3, 8), random);
    case kCoarseMinimum: {
      Stream stream = tree(TreeShape::random, places, random.between(3, 8), random);
      const auto finest = static_cast<int>(stream[0].registers.min_scale.value());
      for (rtl::StreamJob& job : stream) job.registers.min_scale = rtl::Scale(finest + 14);
      return stream;
    }
    case kTroubleScene:
      return trouble_tree(random);
    default:
      return procedural_tree(random);
  }
}

Stream refused_tree(std::size_t reason, bool at_root, Random& random) {
  Stream stream = valid_tree(random.flip() ? kRandomShape : kBalanced, random);
  refuse(stream, at_root ? stream.size() - 1 : random.below(stream.size()), reason, random);
  return stream;
}

std::size_t any_reason(Random& random) { return kNotFinite + random.below(3); }

void append(Stream& stream, const Stream& more) { stream.insert(stream.end(), more.begin(), more.end()); }

/// More open subtrees than the stack has room for: refused, since no 30-bit Morton code makes such a tree.
Stream too_deep(Random& random) {
  TreeEmitter emit;
  const auto leaf = [&] {
    const glm::vec3 corner{random.unit(), random.unit(), random.unit()};
    return emit.leaf({corner, corner + glm::vec3(random.unit())});
  };
  std::vector<TreeNode> open;
  const int subtrees = rtl::kContextStackDepth + random.between(0, 2);
  for (int i = 0; i < subtrees; ++i) {
    const TreeNode left = leaf();
    open.push_back(emit.pair(left, leaf()));
  }
  while (open.size() > 1) {
    const TreeNode right = open.back();
    open.pop_back();
    open.back() = emit.pair(open.back(), right);
  }
  return emit.finish(any_registers(random));
}

/// Trees of a few pairs one behind the other: several are under way at once, and wait for whoever takes their reports.
Stream small_trees(Random& random) {
  Stream stream;
  for (int trees = random.between(3, 6); trees > 0; --trees) {
    const bool single = random.one_in(3);
    append(stream,
           tree(single ? TreeShape::single_pair : TreeShape::random, any_places(random), single ? 1 : 3, random));
  }
  return stream;
}

}  // namespace

std::vector<rtl::StreamJob> make_valid_stream(Random& random) {
  return valid_tree(random.below(kValidStreamClasses), random);
}

std::vector<rtl::StreamJob> make_stream(std::size_t case_class, Random& random) {
  if (case_class < kValidStreamClasses) return valid_tree(case_class, random);
  Stream stream;
  switch (case_class) {
    case kNotFinite:
    case kInverted:
    case kBeyondExactness:
      return refused_tree(case_class, false, random);
    case kRefusedRoot:
      return refused_tree(any_reason(random), true, random);
    case kTooDeep:
      return too_deep(random);
    case kSmallTrees:
      return small_trees(random);
    case kTwoTrees:
      stream = make_valid_stream(random);
      break;
    default: {  // kRefusedThenValid
      const bool at_root = random.one_in(4);
      stream = refused_tree(any_reason(random), at_root, random);
    }
  }
  append(stream, make_valid_stream(random));
  return stream;
}

}  // namespace cbvh::vectors
