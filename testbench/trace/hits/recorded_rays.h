// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/trace/traced_mesh.h"

namespace cbvh::testbench {

/// A TracedMesh that notes every ray: all rays of a picture, primary and secondary ones.
template <class View>
class RecordedRays {
 public:
  using Hit = golden::Hit;

  RecordedRays(const View& view, const golden::Mesh& mesh, std::vector<golden::Ray>& rays)
      : traced_(view, mesh), rays_(&rays) {}

  const golden::Box& box() const { return traced_.box(); }
  Hit trace(const golden::Ray& ray, golden::Stop stop) {
    rays_->push_back(ray);
    return traced_.trace(ray, stop);
  }
  const golden::TraceCounts& counts() const { return traced_.counts(); }
  auto surface(const golden::Ray& ray, const Hit& hit) const { return traced_.surface(ray, hit); }

 private:
  golden::TracedMesh<View> traced_;
  std::vector<golden::Ray>* rays_;
};

}  // namespace cbvh::testbench
