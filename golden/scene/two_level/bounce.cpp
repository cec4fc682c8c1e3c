// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "golden/quantize/exact.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/two_level/two_level_scenes.h"

namespace cbvh::golden {
namespace {

/// x modulo 4, shifted so that 0 stays 0: in [-1, 3).
float wrapped(float x) { return x - 4.0F * static_cast<float>(exact_floor(static_cast<double>(x + 1.0F) / 4.0)); }

/// Where x is after bouncing off walls at -1 and 1.
float bounced(float x) {
  const float w = wrapped(x);
  return w <= 1.0F ? w : 2.0F - w;
}

/// A quaternion that turns steadily about `axis` as `phase` grows, half a turn in 2: rational pieces of (1, u * axis),
/// u from -1 to 1, every other one turned by half a turn; they meet at quarter turns.
struct Quaternion {
  float w;
  glm::vec3 v;
};
Quaternion turned(const glm::vec3& axis, float phase) {
  const float w = wrapped(phase);
  return w <= 1.0F ? Quaternion{1.0F, axis * w} : Quaternion{2.0F - w, axis};
}

/// The rotation of a quaternion of any length, times `scale`.
glm::mat4 rotation(const Quaternion& q, float scale) {
  const float w = q.w;
  const auto [x, y, z] = std::array{q.v.x, q.v.y, q.v.z};
  const float ww = w * w;
  const float xx = x * x;
  const float yy = y * y;
  const float zz = z * z;
  const float s = scale / (ww + xx + yy + zz);
  glm::mat4 m(1.0F);
  m[0] = {(ww + xx - yy - zz) * s, 2.0F * (x * y + w * z) * s, 2.0F * (x * z - w * y) * s, 0.0F};
  m[1] = {2.0F * (x * y - w * z) * s, (ww - xx + yy - zz) * s, 2.0F * (y * z + w * x) * s, 0.0F};
  m[2] = {2.0F * (x * z + w * y) * s, 2.0F * (y * z - w * x) * s, (ww - xx - yy + zz) * s, 0.0F};
  return m;
}

TwoLevelScene make(Mesh mesh, const OptionValues& options) {
  Random random(options.integer("seed"));
  const float time = options.real("time") * options.real("speed");
  glm::vec3 lower = mesh.positions.front();
  glm::vec3 upper = lower;
  for (const glm::vec3& p : mesh.positions) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  const glm::vec3 centre = lower * 0.5F + upper * 0.5F;
  const glm::vec3 half = upper * 0.5F - lower * 0.5F;
  const float widest = std::max({half.x, half.y, half.z});
  const float scale = widest > 0 ? options.real("size") / widest : 1.0F;

  TwoLevelScene scene;
  scene.objects.push_back(std::move(mesh));
  const std::uint64_t count = options.integer("count");
  scene.instances.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const glm::vec3 start = random.in_cube(1.0F);
    const glm::vec3 heading = random.direction();
    const glm::vec3 velocity = heading * random.between(0.1F, 0.5F);
    const glm::vec3 axis = random.direction();
    const float phase = random.between(-1.0F, 3.0F);
    const float spin = random.between(0.1F, 1.0F);
    glm::mat4 m = rotation(turned(axis, phase + spin * time), scale);
    for (glm::length_t row = 0; row < 3; ++row) {
      m[3][row] = bounced(start[row] + velocity[row] * time) -
                  (m[0][row] * centre.x + m[1][row] * centre.y + m[2][row] * centre.z);
    }
    scene.instances.push_back({0, m});
  }
  return scene;
}

}  // namespace

TwoLevelKind bounce_kind() {
  return {"bounce",
          "instances that fly, turn and bounce off the walls of a cube of -1 .. 1 (Bikker, part 6); the same ones at "
          "every `time`",
          {{"count", "how many", 256, 1, 65536},
           {"size", "half the widest extent of an instance before it is turned", 0.1, 0.000001, 100, false},
           {"time", "since the start", 0, 0, 1000, false},
           {"speed", "by how much more time passes", 1, 0, 1000, false},
           {"seed", "of all that is random", 1, 0, 9007199254740992.0}},
          make};
}

}  // namespace cbvh::golden
