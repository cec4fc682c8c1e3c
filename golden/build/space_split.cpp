// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/space_split.h"

#include "golden/build/centroid_sweep.h"
#include "golden/build/piece_build.h"

namespace cbvh::golden {
namespace {

class SpaceBuild : public PieceBuild {
 public:
  SpaceBuild(const Mesh& of, const BuildLimits& within, const SpaceRules& by)
      : PieceBuild(of, within, by.references), rules(by) {}

 private:
  bool divide(Part& part, int levels, std::array<Part, 2>& halves) override {
    if (rules.tight) part.cell = box_of(part.pieces);
    const auto count = static_cast<std::uint32_t>(part.pieces.size());
    const double area = half_area(part.cell);
    if (limits.prefer_leaf(count, levels, area, 0)) return false;
    Split objects;
    if (rules.objects) objects = best_centroid(part.pieces);
    const double replaced = rules.objects && objects.exists() ? objects.cost : area * count;
    PlaneSplit plane;
    if (area > 0)
      plane =
          rules.exact_costs ? best_plane_exactly(part.pieces, mesh) : best_plane(part.pieces, part.cell, !rules.tight);
    const bool use_plane = plane.exists() && std::uint64_t{plane.left} + plane.right <= part.allowance &&
                           limits.fit(plane.left, plane.right, levels) && plane.cost <= (1 - rules.gain) * replaced;
    if (!use_plane && !rules.objects && count > limits.leaf) objects = best_centroid(part.pieces);
    if (limits.prefer_leaf(count, levels, area, use_plane ? plane.cost : objects.cost)) return false;
    if (use_plane) {
      divide_space(part, plane, halves);
    } else {
      divide_objects(part, objects, levels, area, halves);
    }
    return true;
  }

  const SpaceRules rules;
};

}  // namespace

FloatTree build_by_space(const Mesh& mesh, const BuildLimits& limits, const SpaceRules& rules) {
  return SpaceBuild(mesh, limits, rules).run();
}

}  // namespace cbvh::golden
