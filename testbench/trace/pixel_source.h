// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "golden/trace/pixel_tracer.h"
#include "golden/trace/two_level/two_level_tracer.h"

namespace cbvh::testbench {

/// A mesh is an instance of its own, the first.
using TracedPixel = golden::Pixel<golden::InstanceHit>;

/// A camera and the rays behind its pixels.
struct Shot {
  golden::Camera camera;
  golden::RayKind kind;
  unsigned samples;
};

/// Pixels of one picture through one tree; one a thread.
class PixelSource {
 public:
  virtual ~PixelSource() = default;
  virtual TracedPixel trace(unsigned x, unsigned y, unsigned width, unsigned height) = 0;
};

/// Those of a golden::TracedMesh or golden::TracedInstances.
template <class Traced>
std::unique_ptr<PixelSource> pixel_source(Traced traced, const Shot& shot) {
  class Source : public PixelSource {
   public:
    Source(Traced traced, const Shot& shot) : tracer_(std::move(traced), shot.camera, shot.kind, shot.samples) {}

    TracedPixel trace(unsigned x, unsigned y, unsigned width, unsigned height) override {
      const auto pixel = tracer_.trace(x, y, width, height);
      return {of_an_instance(pixel.hit), pixel.normal, pixel.light, pixel.primary, pixel.secondary};
    }

   private:
    static golden::InstanceHit of_an_instance(const golden::InstanceHit& hit) { return hit; }
    static golden::InstanceHit of_an_instance(const golden::Hit& hit) {
      return hit == golden::Hit() ? golden::InstanceHit() : golden::InstanceHit{0, hit.primitive, hit.t};
    }

    golden::PixelTracer<Traced> tracer_;
  };
  return std::make_unique<Source>(std::move(traced), shot);
}

}  // namespace cbvh::testbench
