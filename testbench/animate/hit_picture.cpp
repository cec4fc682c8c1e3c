// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/animate/hit_picture.h"

#include <bit>

#include "golden/threads/parallel_for.h"
#include "testbench/fnv.h"

namespace cbvh::testbench {

HitPicture trace_picture(const golden::FloatTree& tree, const golden::Mesh& mesh, const golden::Camera& camera,
                         unsigned width, unsigned height, unsigned threads) {
  HitPicture picture;
  picture.hits.resize(std::size_t{width} * height);
  std::vector<golden::TraceCounts> counts(height);
  golden::parallel_for(height, threads, [&](std::size_t row) {
    golden::Tracer tracer{golden::FloatTreeView(tree), mesh};
    for (unsigned x = 0; x < width; ++x) {
      const golden::Ray ray = camera.ray(x, static_cast<unsigned>(row), width, height);
      picture.hits[row * width + x] = tracer.trace(ray, golden::Stop::closest);
    }
    counts[row] = tracer.counts();
  });
  for (const golden::TraceCounts& row : counts) picture.counts.add(row);
  return picture;
}

std::uint64_t digest(const HitPicture& picture) {
  Fnv hash;
  for (const golden::Hit& hit : picture.hits) {
    hash.add(hit.primitive);
    hash.add(std::bit_cast<std::uint64_t>(hit.t));
  }
  return hash.value();
}

}  // namespace cbvh::testbench
