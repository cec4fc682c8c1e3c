// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/builder.h"

#include "golden/build/binned.h"
#include "golden/build/early_split.h"
#include "golden/build/edge_volume.h"
#include "golden/build/generic.h"
#include "golden/build/kdtree.h"
#include "golden/build/lbvh.h"
#include "golden/build/median.h"
#include "golden/build/spatial.h"
#include "golden/build/sweep.h"
#include "golden/input_error.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

const BuilderKind& kind_of(const std::string& place, std::string_view description) {
  const std::string_view name = name_of(description);
  const BuilderKind* kind = find_named(builder_kinds(), name);
  if (kind == nullptr)
    throw InputError(place, fmt::format("found {}, wanted one of {}", in_quotes(name), names_of(builder_kinds())));
  return *kind;
}

}  // namespace

const std::vector<BuilderKind>& builder_kinds() {
  static const std::vector<BuilderKind> all = {
      lbvh_builder(),   sweep_builder(),     binned_builder(),  median_builder(),      spatial_builder(),
      kdtree_builder(), geometric_builder(), generic_builder(), early_split_builder(), edge_volume_builder()};
  return all;
}

Builder::Builder(const std::string& place, std::string_view description)
    : text_(description),
      kind_(&kind_of(place, description)),
      options_(read_options(place, description, kind_->options)) {}

std::string builder_help() {
  std::string help;
  for (const BuilderKind& kind : builder_kinds()) {
    help += fmt::format("{}  {}\n", kind.name, kind.meaning);
    help += options_help(kind.options);
  }
  return help;
}

}  // namespace cbvh::golden
