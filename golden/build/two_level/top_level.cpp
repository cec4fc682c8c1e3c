// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/top_level.h"

#include "golden/build/two_level/agglomerative.h"
#include "golden/build/two_level/rebraid.h"
#include "golden/input_error.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

const TopLevelKind& kind_of(const std::string& place, std::string_view description) {
  const std::string_view name = name_of(description);
  const TopLevelKind* kind = find_named(top_level_kinds(), name);
  if (kind == nullptr)
    throw InputError(
        place, fmt::format("top level: found {}, wanted one of {}", in_quotes(name), names_of(top_level_kinds())));
  return *kind;
}

}  // namespace

const std::vector<TopLevelKind>& top_level_kinds() {
  static const std::vector<TopLevelKind> all = {agglomerative_top_level(), plain_top_level(), rebraid_top_level()};
  return all;
}

TopLevelBuilder::TopLevelBuilder(const std::string& place, std::string_view description)
    : text_(description),
      kind_(&kind_of(place, description)),
      options_(read_options(place, description, kind_->options)) {}

TopLevel TopLevelBuilder::build(const InstancedTrees& trees) const {
  const TwoLevelScene& scene = *trees.scene;
  if (trees.trees.size() != scene.objects.size())
    throw InputError(scene.name, fmt::format("found {} trees, wanted one for each of {} objects", trees.trees.size(),
                                             scene.objects.size()));
  for (std::size_t i = 0; i < trees.trees.size(); ++i) {
    if (trees.trees[i]->primitives() != scene.objects[i].triangles.size())
      throw InputError(fmt::format("{}: object {}", scene.name, i),
                       fmt::format("found a tree of {} primitives, wanted one of {}", trees.trees[i]->primitives(),
                                   scene.objects[i].triangles.size()));
  }
  return kind_->build(trees, options_);
}

std::string top_level_help() {
  std::string help;
  for (const TopLevelKind& kind : top_level_kinds()) {
    help += fmt::format("{}  {}\n", kind.name, kind.meaning);
    help += options_help(kind.options);
  }
  return help;
}

}  // namespace cbvh::golden
