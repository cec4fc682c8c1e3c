// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/unit.h"

/// One function a unit, each in a source of its own: they instantiate a set for every N.
namespace cbvh::vectors {

UnitDescription describe_axis_compressor();
UnitDescription describe_scale_estimator();
UnitDescription describe_node_pair_compressor();
UnitDescription describe_node_pair_compressor_serial();
UnitDescription describe_context_stack();
UnitDescription describe_backtrack_unit();
UnitDescription describe_treelet_collector();
UnitDescription describe_lazy_treelet_collector();
UnitDescription describe_stream_compressor();
UnitDescription describe_node_writer();
UnitDescription describe_tree_reader();
UnitDescription describe_id_reader();
UnitDescription describe_primitive_gatherer();
UnitDescription describe_refit_walker();
UnitDescription describe_refit_unit();
UnitDescription describe_top_down_compressor();
UnitDescription describe_box_decoder();
UnitDescription describe_ray_setter();
UnitDescription describe_pair_intersector();
UnitDescription describe_traversal_unit();
UnitDescription describe_primitive_reader();
UnitDescription describe_box_builder();
UnitDescription describe_morton_encoder();
UnitDescription describe_run_sorter();
UnitDescription describe_run_writer();
UnitDescription describe_run_merger();
UnitDescription describe_hierarchy_emitter();
UnitDescription describe_id_writer();
UnitDescription describe_float_node_writer();

}  // namespace cbvh::vectors
