// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/float_trees.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "golden/quantize/quantize.h"
#include "vectors/convert.h"

namespace cbvh::vectors {
namespace {

/// The largest |coordinate| of a box.
float magnitude_of(const rtl::FloatBox& box) {
  float largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::fabs(box.lower[axis].value()), std::fabs(box.upper[axis].value())});
  }
  return largest;
}

/// Makes trees from the root's region downwards; the boxes come out of the leaves.
class Grower {
 public:
  Grower(TreePlaces places, Random& random, TreeEmitter& emitter) : places_(places), random_(random), emit_(emitter) {
    const float size = std::ldexp(1.0F, random.between(-12, 12));
    const float far = places == TreePlaces::negative ? -size * static_cast<float>(random.between(50, 5000)) : 0.0F;
    const bool centred = random.flip();
    for (int axis = 0; axis < 3; ++axis) {
      region_.lower[axis] = far + (centred ? -size * random.unit() : 0.0F);
      region_.upper[axis] = region_.lower[axis] + size * (0.5F + random.unit());
      if (places == TreePlaces::full_span) {
        region_.lower[axis] = size * static_cast<float>(random.between(-2, 1));
        region_.upper[axis] = region_.lower[axis] + size;
      }
    }
    if (places == TreePlaces::planar) region_.upper[plane_axis()] = region_.lower[plane_axis()];
    shared_ = box_in(region_);
  }

  TreeNode grow(TreeShape shape, int levels) { return grow(shape, levels, region_); }

 private:
  int plane_axis() const { return 2; }

  TreeNode grow(TreeShape shape, int levels, const golden::Box& region) {
    if (levels == 0) return emit_.leaf(leaf_box(region));
    const std::pair<golden::Box, golden::Box> both = halves(region);
    const golden::Box& left = both.first;
    const golden::Box& right = both.second;
    switch (shape) {
      case TreeShape::single_pair:
        return join(grow(shape, 0, left), [&] { return grow(shape, 0, right); });
      case TreeShape::left_spine:
        return join(grow(shape, levels - 1, left), [&] { return grow(shape, 0, right); });
      case TreeShape::right_spine:
        return join(grow(shape, 0, left), [&] { return grow(shape, levels - 1, right); });
      case TreeShape::pending_spine:
        return join(grow(TreeShape::single_pair, levels > 1 ? 1 : 0, left),
                    [&] { return grow(shape, levels - 1, right); });
      case TreeShape::balanced:
        return join(grow(shape, levels - 1, left), [&] { return grow(shape, levels - 1, right); });
      case TreeShape::random:
        break;
    }
    const auto below = [&] { return random_.one_in(3) ? 0 : random_.between(0, levels - 1); };
    const int left_levels = below();
    return join(grow(shape, left_levels, left), [&] { return grow(shape, below(), right); });
  }

  /// The left subtree is emitted before the right one is begun.
  template <class Right>
  TreeNode join(const TreeNode& left, Right&& right) {
    return emit_.pair(left, right());
  }

  std::pair<golden::Box, golden::Box> halves(const golden::Box& region) {
    std::pair<golden::Box, golden::Box> result{region, region};
    if (places_ == TreePlaces::scattered || places_ == TreePlaces::negative) return result;
    int axis = static_cast<int>(random_.below(3));
    if (places_ == TreePlaces::planar && axis == plane_axis()) axis = 0;
    const float share = places_ == TreePlaces::full_span ? 0.5F : 0.25F + 0.5F * random_.unit();
    const float middle = region.lower[axis] + (region.upper[axis] - region.lower[axis]) * share;
    result.first.upper[axis] = middle;
    result.second.lower[axis] = middle;
    return result;
  }

  float within(float lower, float upper) { return std::clamp(lower + (upper - lower) * random_.unit(), lower, upper); }

  golden::Box box_in(const golden::Box& region) {
    golden::Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const float a = within(region.lower[axis], region.upper[axis]);
      const float b = random_.one_in(8) ? a : within(region.lower[axis], region.upper[axis]);
      box.lower[axis] = std::min(a, b);
      box.upper[axis] = std::max(a, b);
    }
    return box;
  }

  golden::Box leaf_box(const golden::Box& region) {
    switch (places_) {
      case TreePlaces::identical:
        return shared_;
      case TreePlaces::full_span: {  // one last place inside, so that the sizes are 2^N cells
        golden::Box box = region;
        for (int axis = 0; axis < 3; ++axis) {
          if (box.upper[axis] > box.lower[axis]) box.upper[axis] = std::nextafter(box.upper[axis], box.lower[axis]);
        }
        return box;
      }
      case TreePlaces::points: {
        golden::Box box = box_in(region);
        box.upper = box.lower;
        return box;
      }
      default:
        return box_in(region);
    }
  }

  TreePlaces places_;
  Random& random_;
  TreeEmitter& emit_;
  golden::Box region_{};
  golden::Box shared_{};
};

}  // namespace

TreeNode TreeEmitter::pair(const TreeNode& left, const TreeNode& right) {
  rtl::StreamJob job;
  const TreeNode* children[] = {&left, &right};
  for (std::size_t c = 0; c < 2; ++c) {
    job.pair.box[c] = float_box(children[c]->box);
    job.pair.leaf[c] = rtl::UInt<1>(children[c]->leaf);
    job.pair.pointer[c] = rtl::Pointer(children[c]->pointer);
  }
  jobs_.push_back(job);
  return {golden::unite(left.box, right.box), false, static_cast<std::uint32_t>(jobs_.size() - 1)};
}

std::vector<rtl::StreamJob> TreeEmitter::finish(const rtl::SceneRegisters& registers) {
  float largest = 0;
  for (const rtl::StreamJob& job : jobs_) {
    for (const rtl::FloatBox& box : job.pair.box) largest = std::max(largest, magnitude_of(box));
  }
  rtl::SceneRegisters allowed = registers;
  const int limit = golden::exactness_limit(largest);
  allowed.min_scale = rtl::Scale(std::max(limit, static_cast<int>(registers.min_scale.value())));
  for (rtl::StreamJob& job : jobs_) job.registers = allowed;
  if (!jobs_.empty()) jobs_.back().root = rtl::UInt<1>(1);
  return std::move(jobs_);
}

TreeEmitter random_tree(TreeShape shape, TreePlaces places, int levels, Random& random) {
  TreeEmitter emitter;
  Grower(places, random, emitter).grow(shape, std::clamp(levels, 1, 31));
  return emitter;
}

std::vector<rtl::StreamJob> stream_of(const golden::FloatTree& tree, const rtl::SceneRegisters& registers) {
  std::vector<rtl::StreamJob> jobs;
  jobs.reserve(tree.pairs.size());
  for (std::size_t i = 0; i < tree.pairs.size(); ++i) jobs.push_back(stream_job(tree, i, registers));
  return jobs;
}

}  // namespace cbvh::vectors
