// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/registry.h"

#include <algorithm>

#include "vectors/units/describe.h"

namespace cbvh::vectors {
namespace {

std::string join(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += (text.empty() ? "" : ", ") + std::to_string(value);
  return text;
}

void check_parameter(const UnitDescription& unit, const char* name, int value, const std::vector<int>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
  throw golden::InputError(name, fmt::format("found {}, want {} for {}", value, join(allowed), unit.name));
}

}  // namespace

std::span<const UnitDescription> units() {
  static const std::vector<UnitDescription> all = {describe_axis_compressor(),
                                                   describe_scale_estimator(),
                                                   describe_node_pair_compressor(),
                                                   describe_node_pair_compressor_serial(),
                                                   describe_context_stack(),
                                                   describe_backtrack_unit(),
                                                   describe_treelet_collector(),
                                                   describe_lazy_treelet_collector(),
                                                   describe_stream_compressor(),
                                                   describe_primitive_reader(),
                                                   describe_box_builder(),
                                                   describe_morton_encoder(),
                                                   describe_run_sorter(),
                                                   describe_run_writer(),
                                                   describe_run_merger(),
                                                   describe_hierarchy_emitter(),
                                                   describe_id_writer(),
                                                   describe_float_node_writer(),
                                                   describe_node_writer(),
                                                   describe_tree_reader(),
                                                   describe_id_reader(),
                                                   describe_primitive_gatherer(),
                                                   describe_refit_walker(),
                                                   describe_refit_unit(),
                                                   describe_top_down_compressor(),
                                                   describe_box_decoder(),
                                                   describe_ray_setter(),
                                                   describe_pair_intersector(),
                                                   describe_traversal_unit()};
  return all;
}

const UnitDescription& find_unit(std::string_view name) {
  std::string names;
  for (const UnitDescription& unit : units()) {
    if (unit.name == name) return unit;
    names += (names.empty() ? "" : ", ") + std::string(unit.name);
  }
  throw golden::InputError("unit", fmt::format("unknown unit '{}', want one of {}", name, names));
}

std::unique_ptr<VectorSet> make_set(const UnitDescription& unit, const Parameters& parameters, std::uint64_t seed) {
  check_parameter(unit, "bits", parameters.bits, unit.bits);
  check_parameter(unit, "treelet", parameters.treelet, unit.treelets);
  return unit.empty_set(unit, parameters, seed);
}

std::unique_ptr<VectorSet> generate_set(std::string_view unit, const Parameters& parameters, std::uint64_t cases,
                                        std::uint64_t seed, Shard shard) {
  if (shard.index >= shard.count) {
    throw golden::InputError("shard",
                             fmt::format("found {}/{}, want an index below the count", shard.index, shard.count));
  }
  std::unique_ptr<VectorSet> set = make_set(find_unit(unit), parameters, seed);
  for (std::uint64_t id = shard.index; id < cases; id += shard.count) set->generate_case(id);
  return set;
}

}  // namespace cbvh::vectors
