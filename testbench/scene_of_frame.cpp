// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/scene_of_frame.h"

#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/twist.h"

namespace cbvh::testbench {

namespace {

constexpr std::string_view kTime = "{time}";

double time_of_frame(const MovingScene& scene, unsigned frame) {
  return scene.frames == 1 ? 1 : static_cast<double>(frame) / (scene.frames - 1);
}

}  // namespace

void check_moving_scene(const MovingScene& scene) {
  if (scene.frames == 0) throw golden::InputError("--frames", "found 0, want 1 or more");
  const bool moves = scene.twist != 0 || scene.scene.find(kTime) != std::string::npos;
  if (scene.frames > 1 && !moves)
    throw golden::InputError("--frames", "nothing moves: want {time} in the scene, or --twist");
}

std::string name_of_frame(const MovingScene& scene, unsigned frame) {
  std::string name = scene.scene;
  const std::size_t place = name.find(kTime);
  if (place != std::string::npos) name.replace(place, kTime.size(), fmt::format("{}", time_of_frame(scene, frame)));
  return name;
}

golden::Mesh scene_of_frame(const MovingScene& scene, unsigned frame) {
  golden::Mesh mesh = golden::load_scene(name_of_frame(scene, frame));
  if (scene.twist == 0) return mesh;
  return golden::twisted(std::move(mesh), static_cast<float>(scene.twist * time_of_frame(scene, frame)));
}

}  // namespace cbvh::testbench
