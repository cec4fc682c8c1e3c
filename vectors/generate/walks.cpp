// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/walks.h"

#include <algorithm>
#include <cmath>

#include "vectors/generate/float_trees.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSinglePair,
  kLeftSpine,
  kRightSpine,
  kPending,
  kBalanced,
  kRandomShape,
  kBigLeaves,
  kAdjacentBounds,
  kWrongChild,
  kWrongLeaf,
  kFlippedLeafBit,
  kIdsMissing,
  kUnterminated,
  kMoreIds,
  kOpenNodes,
  kOutOfRange,
  kNotFinite,
  kTooDeep,
  kAnyTopology,
  kTwoTrees
};
static_assert(kTwoTrees == kTwoWalksClass);

golden::Box plain_box(const rtl::FloatBox& box) {
  golden::Box plain;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    plain.lower[axis] = box.lower[a].value();
    plain.upper[axis] = box.upper[a].value();
  }
  return plain;
}

/// A tree of the compressor's generator whose leaves get up to `most` primitives each.
PlainWalk walk_of(const std::vector<rtl::StreamJob>& jobs, int most, Random& random) {
  std::vector<golden::Box> leaf_boxes(jobs.size() + 1);
  for (const rtl::StreamJob& job : jobs) {
    for (std::size_t c = 0; c < 2; ++c) {
      if (job.pair.leaf[c]) leaf_boxes[job.pair.pointer[c].raw()] = plain_box(job.pair.box[c]);
    }
  }
  PlainWalk walk;
  walk.registers = jobs.back().registers;
  std::vector<std::size_t> first;
  for (const golden::Box& box : leaf_boxes) {
    first.push_back(walk.primitives.size());
    for (int more = random.between(1, most); more > 1; --more) {
      walk.primitives.push_back({leaf_boxes[random.below(leaf_boxes.size())], false});
    }
    walk.primitives.push_back({box, true});
  }
  for (const rtl::StreamJob& job : jobs) {
    walk.pairs.push_back({job.pair.leaf, job.pair.pointer, job.root});
    for (std::size_t c = 0; c < 2; ++c) {
      if (job.pair.leaf[c]) walk.pairs.back().pointer[c] = rtl::Pointer(first[job.pair.pointer[c].raw()]);
    }
  }
  return walk;
}

PlainWalk shaped(TreeShape shape, int levels, int most, Random& random) {
  const auto places = static_cast<TreePlaces>(random.below(7));
  const rtl::SceneRegisters registers{rtl::Scale(-149), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
  return walk_of(random_tree(shape, places, levels, random).finish(registers), most, random);
}

/// Bounds that differ in their last places only, of either sign.
void bring_together(PlainWalk& walk, Random& random) {
  for (int axis = 0; axis < 3; ++axis) {
    const float base = (axis == 2 ? 1.0F : -1.0F) * (1.0F + random.unit());
    const auto near = [&](int places) {
      float x = base;
      for (; places > 0; --places) x = std::nextafter(x, 8.0F);
      return x;
    };
    for (WalkPrimitive& primitive : walk.primitives) {
      primitive.box.lower[axis] = near(random.between(0, 3));
      primitive.box.upper[axis] = near(random.between(4, 7));
    }
  }
}

PlainWalk valid_walk(std::size_t case_class, Random& random) {
  const int levels = random.one_in(6) ? random.between(2, 31) : random.between(2, 5);
  switch (case_class) {
    case kSinglePair:
      return shaped(TreeShape::single_pair, 1, random.between(1, 2), random);
    case kLeftSpine:
      return shaped(TreeShape::left_spine, levels, 1, random);
    case kRightSpine:
      return shaped(TreeShape::right_spine, levels, 1, random);
    case kPending:
      return shaped(TreeShape::pending_spine, std::min(levels, 16), 1, random);
    case kBalanced:
      return shaped(TreeShape::balanced, random.between(2, 3), 1, random);
    case kBigLeaves:
      return shaped(TreeShape::random, 3, 4, random);
    case kAdjacentBounds: {
      PlainWalk walk = shaped(TreeShape::random, 5, 2, random);
      bring_together(walk, random);
      return walk;
    }
    default:
      return shaped(TreeShape::random, random.between(2, 5), 2, random);
  }
}

/// The place of a child of a kind, if there is one.
struct Child {
  std::size_t pair;
  std::size_t child;
};
std::vector<Child> children(const PlainWalk& walk, bool leaf) {
  std::vector<Child> found;
  for (std::size_t i = 0; i < walk.pairs.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      if (bool(walk.pairs[i].leaf[c]) == leaf) found.push_back({i, c});
    }
  }
  return found;
}

void misplace(PlainWalk& walk, bool leaf, Random& random) {
  const std::vector<Child> all = children(walk, leaf);
  if (all.empty()) return;
  const Child child = all[random.below(all.size())];
  rtl::Pointer& pointer = walk.pairs[child.pair].pointer[child.child];
  const std::uint64_t other = random.one_in(4) ? random.next() : pointer.raw() + (random.flip() ? 1 : ~0ULL);
  pointer = rtl::Pointer::of_raw(other);
}

/// One pair, and more leaves before its right one than the stack has room for.
PlainWalk too_deep(Random& random) {
  PlainWalk walk = shaped(TreeShape::single_pair, 1, 1, random);
  const int leaves = random.between(31, 34);
  while (walk.primitives.size() < static_cast<std::size_t>(leaves)) walk.primitives.push_back(walk.primitives.front());
  walk.pairs[0].pointer[1] = rtl::Pointer(walk.primitives.size() - (random.flip() ? 1 : 0));
  return walk;
}

void spoil(PlainWalk& walk, std::size_t case_class, Random& random) {
  rtl::TopologyPair& pair = walk.pairs[random.below(walk.pairs.size())];
  WalkPrimitive& primitive = walk.primitives[random.below(walk.primitives.size())];
  switch (case_class) {
    case kWrongChild:
      misplace(walk, false, random);
      break;
    case kWrongLeaf:
      misplace(walk, true, random);
      break;
    case kFlippedLeafBit: {
      rtl::UInt<1>& leaf = pair.leaf[random.below(2)];
      leaf = rtl::UInt<1>(!leaf);
      break;
    }
    case kIdsMissing:
      walk.primitives.pop_back();
      walk.primitives.back().last_of_leaf = true;
      break;
    case kUnterminated:
      walk.primitives.back().last_of_leaf = false;
      break;
    case kMoreIds:
      for (int more = random.between(1, 3); more > 0; --more) {
        walk.primitives.push_back({walk.primitives.front().box, more == 1 || random.flip()});
      }
      break;
    case kOpenNodes:  // the root pair is not the last of the tree
      if (walk.pairs.size() > 1) walk.pairs.pop_back();
      walk.pairs.back().last = rtl::UInt<1>(1);
      break;
    case kOutOfRange:
      primitive.in_range = false;
      primitive.box = {};
      break;
    case kNotFinite:
      primitive.finite = false;
      primitive.box = {};
      break;
    default:  // kAnyTopology
      for (std::size_t c = 0; c < 2; ++c) {
        pair.leaf[c] = rtl::UInt<1>(random.flip());
        pair.pointer[c] = rtl::Pointer(random.below(walk.pairs.size() + walk.primitives.size()));
      }
  }
}

}  // namespace

PlainWalk make_walk(std::size_t case_class, Random& random) {
  if (case_class < kWrongChild) return valid_walk(case_class, random);
  if (case_class == kTooDeep) return too_deep(random);
  if (case_class == kTwoTrees) return make_walk(random.below(kTwoTrees), random);
  PlainWalk walk = valid_walk(kRandomShape, random);
  spoil(walk, case_class, random);
  return walk;
}

}  // namespace cbvh::vectors
