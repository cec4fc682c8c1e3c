// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/early_split.h"

#include "golden/build/piece_build.h"
#include "golden/build/presplit.h"
#include "golden/build/wide_box.h"

namespace cbvh::golden {
namespace {

struct ClippedShard {
  double measure;  ///< half area
  Piece piece;
};

FloatTree build_early_split(const Mesh& mesh, const OptionValues& options) {
  const std::uint64_t most = options.integer("references");
  check_references(mesh, most);
  const std::vector<Box> boxes = triangle_boxes(mesh);
  std::vector<ClippedShard> shards;
  Box scene = boxes.front();
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    shards.push_back({half_area(boxes[id]), {boxes[id], id}});
    scene = unite(scene, boxes[id]);
  }
  const auto halves_of = [&](const ClippedShard& shard) {
    std::vector<ClippedShard> halves;
    const Box& box = shard.piece.box;
    const int axis = longest_axis(widened(box));
    const float middle = box.lower[axis] * 0.5F + box.upper[axis] * 0.5F;
    if (!(box.lower[axis] < middle && middle < box.upper[axis])) return halves;
    for (const Box& half : {below(box, axis, middle), above(box, axis, middle)}) {
      if (const auto part = clipped_box(corners_of(mesh, shard.piece.id), half))
        halves.push_back({half_area(*part), {*part, shard.piece.id}});
    }
    return halves;
  };
  const std::vector<Piece> pieces =
      divide_largest(shards, options.values.at("area") * half_area(scene), most, halves_of);
  return sweep_pieces(pieces, mesh, options);
}

}  // namespace

BuilderKind early_split_builder() {
  std::vector<Option> options = limit_options();
  options.push_back({"area", "largest area of a triangle's box, over the scene's", 0.001, 0, 1, false});
  options.push_back(references_option());
  return {"early-split", "ESC-BVH: triangles clipped to small boxes, then the sweep (Popov et al., section 5.1)",
          options, build_early_split};
}

}  // namespace cbvh::golden
