// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"

#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

const std::vector<ProceduralScene>& scenes() {
  static const std::vector<ProceduralScene> all = {cloth_scene(),    soup_scene(), spheres_scene(), terrain_scene(),
                                                   hairball_scene(), city_scene(), explode_scene(), morph_scene()};
  return all;
}

}  // namespace

Mesh make_procedural_scene(const std::string& spec, std::string_view description) {
  const std::string_view name = name_of(description);
  const ProceduralScene* scene = find_named(scenes(), name);
  if (scene == nullptr)
    throw InputError(spec,
                     fmt::format("procedural scene: found {}, wanted one of {}", in_quotes(name), names_of(scenes())));
  return scene->make(read_options(spec, description, scene->options));
}

std::vector<std::string> procedural_scene_names() {
  std::vector<std::string> names;
  for (const ProceduralScene& scene : scenes()) names.push_back(scene.name);
  return names;
}

std::string procedural_scene_help() {
  std::string help;
  for (const ProceduralScene& scene : scenes()) {
    help += fmt::format("proc:{}  {}\n", scene.name, scene.meaning);
    help += options_help(scene.options);
  }
  return help;
}

Option triangles_option(std::uint64_t initial, std::uint64_t least) {
  return {"triangles", "size", static_cast<double>(initial), static_cast<double>(least),
          static_cast<double>(kMostTriangles)};
}

Option seed_option() { return {"seed", "of all that is random", 1, 0, 9007199254740992.0}; }

}  // namespace cbvh::golden
