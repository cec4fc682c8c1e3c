// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

struct SceneOption {
  std::string name;
  std::string meaning;
  double initial;
  double least;
  double greatest;
  bool is_integer = true;
};

/// The values of a scene's options: all of them, each in its range.
class SceneOptions {
 public:
  std::uint64_t integer(const std::string& name) const { return static_cast<std::uint64_t>(values.at(name)); }
  float real(const std::string& name) const { return static_cast<float>(values.at(name)); }

  std::map<std::string, double> values;
};

struct ProceduralScene {
  std::string name;
  std::string meaning;  ///< and how many triangles result
  std::vector<SceneOption> options;
  Mesh (*make)(const SceneOptions&);
};

/// "NAME[,key=value...]" to a mesh. `spec` is the place that errors name.
Mesh make_procedural_scene(const std::string& spec, std::string_view description);

// One of each file in this folder.
ProceduralScene cloth_scene();
ProceduralScene soup_scene();
ProceduralScene spheres_scene();
ProceduralScene terrain_scene();
ProceduralScene hairball_scene();
ProceduralScene city_scene();
ProceduralScene explode_scene();

// Options that most scenes have.
inline constexpr std::uint64_t kMostTriangles = std::uint64_t{1} << 22;
SceneOption triangles_option(std::uint64_t initial, std::uint64_t least);
SceneOption seed_option();

}  // namespace cbvh::golden
