// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/procedural.h"

#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/parse_number.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

const std::vector<ProceduralScene>& scenes() {
  static const std::vector<ProceduralScene> all = {cloth_scene(),    soup_scene(), spheres_scene(), terrain_scene(),
                                                   hairball_scene(), city_scene(), explode_scene()};
  return all;
}

template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::string list;
  for (const Named& one : all) list += (list.empty() ? "" : ", ") + one.name;
  return list;
}

template <class Named>
const Named* find(const std::vector<Named>& all, std::string_view name) {
  for (const Named& one : all) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

std::string range_of(const SceneOption& option) {
  return fmt::format("{} from {} to {}", option.is_integer ? "an integer" : "a number", option.least, option.greatest);
}

double value_of(const SceneOption& option, std::string_view text, const std::string& spec) {
  double value = option.least - 1;
  if (option.is_integer) {
    if (const auto integer = parse_integer<std::int64_t>(text)) value = static_cast<double>(*integer);
  } else {
    if (const auto real = parse_float(text)) value = static_cast<double>(*real);
  }
  const bool in_range = value >= option.least && value <= option.greatest;  // false for NaN
  if (!in_range)
    throw InputError(spec,
                     fmt::format("option {}: found {}, wanted {}", option.name, in_quotes(text), range_of(option)));
  return value;
}

/// Cuts the text up to the next comma off `rest`.
std::string_view next_part(std::string_view& rest) {
  const std::string_view part = rest.substr(0, rest.find(','));
  rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  return part;
}

}  // namespace

Mesh make_procedural_scene(const std::string& spec, std::string_view description) {
  const std::size_t comma = description.find(',');
  const std::string_view name = description.substr(0, comma);
  const ProceduralScene* scene = find(scenes(), name);
  if (scene == nullptr)
    throw InputError(spec,
                     fmt::format("procedural scene: found {}, wanted one of {}", in_quotes(name), names_of(scenes())));

  SceneOptions options;
  bool more = comma != description.npos;
  std::string_view rest = more ? description.substr(comma + 1) : "";
  while (more) {
    more = rest.find(',') != rest.npos;
    const std::string_view part = next_part(rest);
    const std::size_t equals = part.find('=');
    if (equals == part.npos) throw InputError(spec, fmt::format("option: found {}, wanted key=value", in_quotes(part)));
    const std::string_view key = part.substr(0, equals);
    const SceneOption* option = find(scene->options, key);
    if (option == nullptr) {
      throw InputError(spec,
                       fmt::format("option: found {}, wanted one of {}", in_quotes(key), names_of(scene->options)));
    }
    if (!options.values.emplace(option->name, value_of(*option, part.substr(equals + 1), spec)).second) {
      throw InputError(spec, fmt::format("option {}: given twice", option->name));
    }
  }
  for (const SceneOption& option : scene->options) options.values.emplace(option.name, option.initial);
  return scene->make(options);
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
    for (const SceneOption& option : scene.options) {
      help += fmt::format("    {}={}  {}; {}\n", option.name, option.initial, option.meaning, range_of(option));
    }
  }
  return help;
}

SceneOption triangles_option(std::uint64_t initial, std::uint64_t least) {
  return {"triangles", "size", static_cast<double>(initial), static_cast<double>(least),
          static_cast<double>(kMostTriangles)};
}

SceneOption seed_option() { return {"seed", "of all that is random", 1, 0, 9007199254740992.0}; }

}  // namespace cbvh::golden
