// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "golden/scene/mesh.h"

namespace cbvh::testbench {

/// A scene that moves: `{time}` in its name stands for frame / (frames - 1), and a twist grows with it.
struct MovingScene {
  std::string scene;
  double twist = 0;  ///< turns around the y axis at the scene's top in the last frame
  unsigned frames = 1;
};

/// Throws InputError unless there is a frame, and something moves if there are several.
void check_moving_scene(const MovingScene& scene);

/// Its name in a frame, 0 .. frames - 1; of a single frame the last.
std::string name_of_frame(const MovingScene& scene, unsigned frame);

/// The scene of a frame, 0 .. frames - 1; of a single frame the last. Throws InputError as load_scene does.
golden::Mesh scene_of_frame(const MovingScene& scene, unsigned frame);

}  // namespace cbvh::testbench
