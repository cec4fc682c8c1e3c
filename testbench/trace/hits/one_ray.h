// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "golden/trace/ray.h"
#include "testbench/report/json.h"
#include "testbench/trace/traced_scene.h"

namespace cbvh::testbench {

/// "OX,OY,OZ,DX,DY,DZ[,TMIN,TMAX]". Throws InputError at `place`, also for a ray that check_ray refuses.
golden::Ray parse_ray(const std::string& place, const std::string& text);

/// What one ray hits, and what it costs.
struct OneRay {
  std::string text;
  Json json;
  bool pass;  ///< the same hit through both trees, and Embree's, if there is one, is no mistake of ours
};

/// Through the float tree and the compressed one of a mesh, and Embree if this build has it.
OneRay trace_one_ray(const golden::Ray& ray, const TraceTrees& trees);

}  // namespace cbvh::testbench
