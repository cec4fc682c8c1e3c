// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/tree_steps.h"

#include <algorithm>
#include <numeric>

#include "golden/tree/node_pair_format.h"
#include "vectors/generate/float_trees.h"
#include "vectors/generate/walks.h"

namespace cbvh::vectors {
namespace {

/// Words of an array as steps, a line each.
template <class Step>
void put(std::vector<Step>& steps, std::uint64_t first_line, const std::vector<std::uint32_t>& words) {
  for (std::size_t i = 0; i < words.size(); i += 16) {
    Step step;
    step.line = rtl::LineAddress(first_line + i / 16);
    for (std::size_t j = i; j < std::min(i + 16, words.size()); ++j) step.words[j - i] = rtl::UInt<32>(words[j]);
    steps.push_back(step);
  }
}

// Refit.

enum RefitClass : std::size_t {
  kSinglePair,
  kLeftSpine,
  kRightSpine,
  kBalanced,
  kRandomShape,
  kBigLeaves,
  kNegativeZero,
  kWrongTree,
  kOutOfRange,
  kNotFinite
};

std::size_t walk_class(std::size_t refit_class, Random& random) {
  const auto named = [](std::string_view name) {
    return static_cast<std::size_t>(std::find(kWalkClasses.begin(), kWalkClasses.end(), name) - kWalkClasses.begin());
  };
  constexpr std::string_view kWrong[] = {"wrong-child",  "wrong-leaf", "flipped-leaf-bit", "ids-missing",
                                         "unterminated", "more-ids",   "open-nodes",       "any-topology"};
  if (refit_class == kNegativeZero) return named("random-shape");
  return named(refit_class == kWrongTree ? kWrong[random.below(std::size(kWrong))] : kRefitClasses[refit_class]);
}

/// Old codes that mean nothing any more.
std::vector<std::uint32_t> packed_pairs(const PlainWalk& walk, Random& random) {
  std::vector<std::uint32_t> words;
  for (const rtl::TopologyPair& pair : walk.pairs) {
    golden::CompressedPair packed{};
    for (std::size_t c = 0; c < 2; ++c) {
      for (auto& codes : packed.child[c].codes) {
        codes = {static_cast<std::uint8_t>(random.below(64)), static_cast<std::uint8_t>(random.below(64))};
      }
      packed.child[c].leaf = bool(pair.leaf[c]);
      packed.child[c].pointer = static_cast<std::uint32_t>(pair.pointer[c].raw());
    }
    for (const std::uint64_t word : golden::pack_node_pair(packed)) {
      words.push_back(static_cast<std::uint32_t>(word));
      words.push_back(static_cast<std::uint32_t>(word >> 32));
    }
  }
  return words;
}

/// A triangle with this box: two opposite corners, and a vertex between.
std::vector<std::uint32_t> triangle(const golden::Box& box, std::uint32_t id, bool negative_zero, Random& random) {
  std::array<glm::vec3, 3> vertices{box.lower, box.upper, random.flip() ? box.lower : box.upper};
  std::vector<std::uint32_t> words;
  const std::size_t first = random.below(3);
  for (std::size_t v = 0; v < 3; ++v) {
    for (int axis = 0; axis < 3; ++axis) words.push_back(rtl::Float32::of(vertices[(first + v) % 3][axis]).bits);
  }
  for (std::uint32_t& word : words) {
    if (negative_zero && word == 0 && random.flip()) word = 1U << 31;
  }
  words.push_back(id);
  return words;
}

// Top down.

enum TopDownClass : std::size_t {
  kTopSinglePair,
  kTopLeftSpine,
  kTopRightSpine,
  kTopPending,
  kTopBalanced,
  kTopRandomShape,
  kTopLong,
  kTopRefused,
  kTopWrongPointer,
  kTopTwoParents,
  kTopFlippedLeafBit,
  kTopTooDeep
};

std::vector<rtl::StreamJob> shaped(TreeShape shape, int levels, Random& random) {
  const auto places = static_cast<TreePlaces>(random.below(7));
  const rtl::SceneRegisters registers{rtl::Scale(-149), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
  return random_tree(shape, places, levels, random).finish(registers);
}

std::vector<rtl::StreamJob> valid_tree(std::size_t case_class, Random& random) {
  const int levels = random.one_in(6) ? random.between(2, 31) : random.between(2, 5);
  switch (case_class) {
    case kTopSinglePair:
      return shaped(TreeShape::single_pair, 1, random);
    case kTopLeftSpine:
      return shaped(TreeShape::left_spine, levels, random);
    case kTopRightSpine:
      return shaped(TreeShape::right_spine, levels, random);
    case kTopPending:
      return shaped(TreeShape::pending_spine, std::min(levels, 16), random);
    case kTopBalanced:
      return shaped(TreeShape::balanced, 3, random);
    case kTopLong:  // a child on the left of the root that has not been asked for when its context is known
      return shaped(TreeShape::balanced, random.one_in(4) ? 7 : 6, random);
    default:
      return shaped(TreeShape::random, random.between(3, 6), random);
  }
}

/// A right spine whose left children are pairs: more announced pairs than the stack has room for.
std::vector<rtl::StreamJob> too_deep(Random& random) {
  TreeEmitter emit;
  const auto leaf = [&] {
    const glm::vec3 corner{random.unit(), random.unit(), random.unit()};
    return emit.leaf({corner, corner + glm::vec3(random.unit())});
  };
  std::vector<TreeNode> left;
  for (int i = random.between(32, 34); i > 0; --i) {
    const TreeNode first = leaf();
    left.push_back(emit.pair(first, leaf()));
  }
  TreeNode right = leaf();
  for (; !left.empty(); left.pop_back()) right = emit.pair(left.back(), right);
  return emit.finish({rtl::Scale(-149), rtl::UInt<1>(0), rtl::UInt<1>(random.flip())});
}

void spoil(std::vector<rtl::StreamJob>& jobs, std::size_t case_class, Random& random) {
  rtl::FloatPair& pair = jobs[random.below(jobs.size())].pair;
  const std::size_t child = random.below(2);
  switch (case_class) {
    case kTopRefused:
      for (int count = random.between(1, 2); count > 0; --count) {
        auto& box = jobs[random.below(jobs.size())].pair.box[child];
        const std::size_t axis = random.below(3);
        if (random.flip()) {
          box.upper[axis] = rtl::Float32::of_raw(0x7F800000);
        } else {
          box.lower[axis] = rtl::Float32::of(std::nextafter(box.upper[axis].value(), 1e38F));
        }
      }
      break;
    case kTopWrongPointer:
      pair.leaf[child] = rtl::UInt<1>(0);
      pair.pointer[child] = rtl::Pointer::of_raw(random.flip() ? random.below(jobs.size() + 1) : random.next());
      break;
    case kTopTwoParents:
      jobs.back().pair.leaf = {};
      jobs.back().pair.pointer[0] = rtl::Pointer(random.below(jobs.size()));
      jobs.back().pair.pointer[1] = jobs.back().pair.pointer[0];
      if (random.flip()) pair.pointer[child] = jobs.back().pair.pointer[0];
      break;
    default:  // kTopFlippedLeafBit
      pair.leaf[child] = rtl::UInt<1>(!pair.leaf[child]);
  }
}

}  // namespace

std::vector<RefitStep> make_refit_steps(std::size_t case_class, Random& random) {
  const PlainWalk walk = make_walk(walk_class(case_class, random), random);
  const std::size_t count = walk.primitives.size();
  std::vector<std::uint32_t> ids(count);
  std::iota(ids.begin(), ids.end(), 0U);
  for (std::size_t i = count; i-- > 1;) std::swap(ids[i], ids[random.below(i + 1)]);
  std::vector<std::uint32_t> primitives(count * 10);
  std::vector<std::uint32_t> entries;
  for (std::size_t i = 0; i < count; ++i) {
    const WalkPrimitive& primitive = walk.primitives[i];
    std::vector<std::uint32_t> words = triangle(primitive.box, ids[i], case_class == kNegativeZero, random);
    if (!primitive.finite) words[random.below(9)] = random.flip() ? 0x7FC00001 : 0xFF800000;
    std::copy(words.begin(), words.end(), primitives.begin() + std::ptrdiff_t{ids[i]} * 10);
    const std::uint32_t id = primitive.in_range ? ids[i] : static_cast<std::uint32_t>(count + random.below(3));
    entries.push_back(id | (primitive.last_of_leaf ? 1U << 31 : 0));
  }
  std::vector<RefitStep> steps;
  put(steps, kRefitPairs, packed_pairs(walk, random));
  put(steps, kRefitIds, entries);
  put(steps, kRefitPrimitives, primitives);
  RefitStep command;
  command.act = rtl::UInt<1>(1);
  command.command = {rtl::ItemCount(walk.pairs.size()), rtl::ItemCount(count), walk.registers};
  steps.push_back(command);
  return steps;
}

std::vector<TopDownStep> make_top_down_steps(std::size_t case_class, Random& random) {
  std::vector<rtl::StreamJob> jobs = case_class == kTopTooDeep ? too_deep(random) : valid_tree(case_class, random);
  if (case_class > kTopLong && case_class != kTopTooDeep) spoil(jobs, case_class, random);
  std::vector<TopDownStep> steps;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::vector<std::uint32_t> words;
    for (std::size_t c = 0; c < 2; ++c) {
      for (const rtl::Float32 x : jobs[i].pair.box[c].lower) words.push_back(x.bits);
      for (const rtl::Float32 x : jobs[i].pair.box[c].upper) words.push_back(x.bits);
      const auto pointer = static_cast<std::uint32_t>(jobs[i].pair.pointer[c].raw());
      words.push_back(pointer | (jobs[i].pair.leaf[c] ? 1U << 31 : 0));
      words.push_back(0);
    }
    put(steps, kTopDownFloatPairs + i, words);
  }
  TopDownStep command;
  command.act = rtl::UInt<1>(1);
  command.command = {rtl::ItemCount(jobs.size()), jobs.back().registers};
  steps.push_back(command);
  return steps;
}

}  // namespace cbvh::vectors
