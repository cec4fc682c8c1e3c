// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/plane_sweep.h"

#include <algorithm>
#include <array>
#include <vector>

#include "golden/build/wide_box.h"

namespace cbvh::golden {
namespace {

std::uint32_t size_of(std::span<const Piece> pieces) { return static_cast<std::uint32_t>(pieces.size()); }

/// The boundaries of pieces along an axis, in order.
struct Events {
  std::vector<float> lowers;
  std::vector<float> uppers;
  std::vector<float> planar;  ///< of pieces without extent
  std::vector<float> planes;  ///< each boundary once

  Events(std::span<const Piece> pieces, int axis) {
    for (const Piece& piece : pieces) {
      lowers.push_back(piece.box.lower[axis]);
      uppers.push_back(piece.box.upper[axis]);
      if (piece.box.lower[axis] == piece.box.upper[axis]) planar.push_back(piece.box.lower[axis]);
    }
    std::sort(lowers.begin(), lowers.end());
    std::sort(uppers.begin(), uppers.end());
    std::sort(planar.begin(), planar.end());
    std::set_union(lowers.begin(), lowers.end(), uppers.begin(), uppers.end(), std::back_inserter(planes));
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  }
};

/// What lies at and beside the plane as it moves up.
class Sweep {
 public:
  explicit Sweep(const Events& from) : events(from) {}

  /// Both ways to treat what lies in the plane, the same one twice if nothing does.
  std::array<PlaneSplit, 2> at(float plane, int axis) {
    while (lower < events.lowers.size() && events.lowers[lower] < plane) ++lower;
    while (upper < events.uppers.size() && events.uppers[upper] <= plane) ++upper;
    while (planar < events.planar.size() && events.planar[planar] < plane) ++planar;
    std::size_t last = planar;
    while (last < events.planar.size() && events.planar[last] == plane) ++last;
    const auto below = static_cast<std::uint32_t>(lower);
    const auto above = static_cast<std::uint32_t>(events.uppers.size() - upper);
    const auto in = static_cast<std::uint32_t>(last - planar);
    return {PlaneSplit{0, axis, plane, true, below + in, above}, PlaneSplit{0, axis, plane, false, below, above + in}};
  }

 private:
  const Events& events;
  std::size_t lower = 0;
  std::size_t upper = 0;
  std::size_t planar = 0;
};

void keep_cheaper(PlaneSplit split, double cost, PlaneSplit& best) {
  split.cost = cost;
  if (cost < best.cost) best = split;
}

}  // namespace

void for_each_plane(std::span<const Piece> pieces, const Box& cell, bool empty_sides,
                    const std::function<void(const PlaneSplit&)>& visit) {
  for (int axis = 0; axis < 3; ++axis) {
    const Events events(pieces, axis);
    Sweep sweep(events);
    for (const float plane : events.planes) {
      const double left_area = half_area(below(cell, axis, plane));
      const double right_area = half_area(above(cell, axis, plane));
      for (PlaneSplit split : sweep.at(plane, axis)) {
        const bool cuts = plane > cell.lower[axis] && plane < cell.upper[axis];
        if ((split.left == 0 || split.right == 0) && !(empty_sides && cuts)) continue;
        split.cost = left_area * split.left + right_area * split.right;
        visit(split);
      }
    }
  }
}

PlaneSplit best_plane(std::span<const Piece> pieces, const Box& cell, bool empty_sides) {
  PlaneSplit best;
  for_each_plane(pieces, cell, empty_sides, [&](const PlaneSplit& split) {
    if (split.cost < best.cost) best = split;
  });
  return best;
}

PlaneSplit best_plane_exactly(std::span<const Piece> pieces, const Mesh& mesh) {
  PlaneSplit best;
  const std::uint32_t count = size_of(pieces);
  std::vector<std::uint32_t> order(count);
  for (int axis = 0; axis < 3; ++axis) {
    const Events events(pieces, axis);
    const std::size_t planes = events.planes.size();
    // [2 k] with the pieces in plane k on the left, [2 k + 1] with them on the right.
    std::vector<double> left_area(2 * planes, 0.0);
    std::vector<double> right_area(2 * planes, 0.0);
    for (const bool upwards : {true, false}) {
      const auto enters = [&](std::uint32_t i) {
        return upwards ? pieces[i].box.lower[axis] : -pieces[i].box.upper[axis];
      };
      const auto leaves = [&](std::uint32_t i) {
        return upwards ? pieces[i].box.upper[axis] : -pieces[i].box.lower[axis];
      };
      for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
      std::sort(order.begin(), order.end(), [&](auto a, auto b) { return enters(a) < enters(b); });
      std::vector<std::uint32_t> queue;  // across the plane
      std::size_t next = 0;
      WideBox passed;
      for (std::size_t step = 0; step < planes; ++step) {
        const std::size_t k = upwards ? step : planes - 1 - step;
        const float plane = events.planes[k];
        const float place = upwards ? plane : -plane;
        while (next < count && enters(order[next]) < place) queue.push_back(order[next++]);
        std::erase_if(queue, [&](std::uint32_t i) {
          if (leaves(i) > place) return false;
          passed.enclose(widened(pieces[i].box));
          return true;
        });
        WideBox box = passed;
        for (const std::uint32_t i : queue) {
          const Box& whole = pieces[i].box;
          const auto part = clipped_box(corners_of(mesh, pieces[i].id),
                                        upwards ? below(whole, axis, plane) : above(whole, axis, plane));
          if (part) box.enclose(widened(*part));
        }
        WideBox with_planar = box;
        for (std::size_t i = next; i < count && enters(order[i]) == place; ++i) {
          if (leaves(order[i]) == place) with_planar.enclose(widened(pieces[order[i]].box));
        }
        const auto area = [](const WideBox& b) { return b.lower[0] > b.upper[0] ? 0.0 : half_area(b); };
        (upwards ? left_area : right_area)[2 * k + (upwards ? 0 : 1)] = area(with_planar);
        (upwards ? left_area : right_area)[2 * k + (upwards ? 1 : 0)] = area(box);
      }
    }
    Sweep sweep(events);
    for (std::size_t k = 0; k < planes; ++k) {
      const auto splits = sweep.at(events.planes[k], axis);
      for (std::size_t side = 0; side < 2; ++side) {
        const PlaneSplit& split = splits[side];
        if (split.left == 0 || split.right == 0) continue;
        keep_cheaper(split, left_area[2 * k + side] * split.left + right_area[2 * k + side] * split.right, best);
      }
    }
  }
  return best;
}

}  // namespace cbvh::golden
