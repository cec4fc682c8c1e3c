// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/two_level/two_level_scenes.h"

#include <new>

#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

TwoLevelScene make_scene(const std::string& spec) {
  const std::size_t colon = spec.find(':');
  if (colon == spec.npos)
    throw InputError(spec, "found no ':' between a kind of two-level scene and a scene, wanted KIND:SCENE");
  const std::string_view description = std::string_view(spec).substr(0, colon);
  const std::string_view name = name_of(description);
  const TwoLevelKind* kind = find_named(two_level_kinds(), name);
  if (kind == nullptr)
    throw InputError(
        spec, fmt::format("two-level scene: found {}, wanted one of {}", in_quotes(name), names_of(two_level_kinds())));
  const OptionValues options = read_options(spec, description, kind->options);
  return kind->make(load_scene(spec.substr(colon + 1)), options);
}

}  // namespace

const std::vector<TwoLevelKind>& two_level_kinds() {
  static const std::vector<TwoLevelKind> all = {bounce_kind(), deal_kind()};
  return all;
}

TwoLevelScene load_two_level_scene(const std::string& spec) {
  try {
    TwoLevelScene scene = make_scene(spec);
    scene.name = spec;
    check_scene(scene);
    return scene;
  } catch (const std::bad_alloc&) {
    throw InputError(spec, "needs more memory than there is");
  }
}

std::string two_level_help() {
  std::string help;
  for (const TwoLevelKind& kind : two_level_kinds()) {
    help += fmt::format("{}:SCENE  {}\n", kind.name, kind.meaning);
    help += options_help(kind.options);
  }
  return help;
}

}  // namespace cbvh::golden
