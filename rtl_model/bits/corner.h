// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cbvh::rtl {

/// The rare branches of the design. Every one is announced where it is decided, so that a regression can prove that it
/// was taken.
enum class Corner : std::uint8_t {
  axis_not_finite,
  axis_inverted,
  axis_beyond_exactness,
  axis_scale_below_minimum,
  axis_too_wide,
  axis_negative_inexact,  ///< floor of a negative coordinate that is not on the grid
  axis_all_bits_dropped,  ///< the cell is larger than the coordinate
  axis_full_grid,         ///< the child spans all cells of the grid
  axis_minimum_scale,     ///< the own grid is held at the minimum scale
  axis_edge_infinite,
  axis_edge_subnormal,
  estimate_one_coarser,  ///< the size alone would be one scale too fine
  estimate_minimum_scale,
  decode_full_span,  ///< an upper code equal to the parent's lower one: s = 2^N
  decode_inverted,
  decode_beyond_exactness,
  decode_scale_below_minimum,
  decode_too_wide,
  coarsen_rounds_up,  ///< an upper edge that moves when it is re-encoded
  child_scale_changed,
  child_lower_changed,  ///< only the lower index changed: matters to relative codes alone
  stack_overflow,
  stack_underflow,
  collector_row_output,
  collector_queue_full,
  collector_flush,
  backtrack_recurses,
  backtrack_both_children,
  backtrack_stops,            ///< a re-encoded pair none of whose children changed
  combiner_merges,            ///< a final pair joins the line that is being combined
  combiner_flushes_for_read,  ///< a repair wants the line that is being combined
  stream_single_pair,
  stream_stops_on_error,
  writer_evicts,     ///< a held line makes room for another
  writer_completes,  ///< the last pair of a held line arrives
  writer_forwards,   ///< a read is answered from a held line
  primitive_not_finite,
  morton_quarter,          ///< the extent of the scene overflows
  morton_flat,             ///< the scene has no extent
  sorter_next_run,         ///< a record that comes too late for the run that is being written
  gatherer_misses,         ///< a primitive's line is not held
  walker_refuses,          ///< the tree does not fit its primitives
  top_down_parks,          ///< a context waits for a pair that has not been read yet
  emitter_joins_leaf,      ///< a record with the code of the one before
  emitter_closes_several,  ///< more than one pair ends before the next record
  emitter_single_leaf,
  merger_tie,        ///< equal codes of two runs: the lower run first
  merger_waits,      ///< a buffer ran dry
  merger_half_line,  ///< a run ends in the middle of a line
  merger_rewrites,   ///< more runs than can be merged at once
  ray_full_span,
  ray_inverted,
  ray_scale_below_minimum,
  ray_too_wide,  ///< a child that reaches beyond its parent, or spans more cells than a grid has
  ray_not_finite,
  ray_beside_box,          ///< parallel to planes that do not have the origin between them
  ray_second_first,        ///< the ray enters the second child before the first
  ray_drops_waiting,       ///< a node that a nearer hit hides
  ray_leaf_crosses_lines,  ///< of the primitive-ID array
  ray_stack_overflow,
  setup_not_finite,
  setup_inverted,
  setup_parallel,
  setup_backwards,
  directed_subnormal,
  directed_beyond_largest,  ///< rounded down to the largest finite float, or to minus infinity
  count
};

constexpr std::size_t kCorners = static_cast<std::size_t>(Corner::count);

constexpr std::array<std::string_view, kCorners> kCornerNames = {
    "axis_not_finite",
    "axis_inverted",
    "axis_beyond_exactness",
    "axis_scale_below_minimum",
    "axis_too_wide",
    "axis_negative_inexact",
    "axis_all_bits_dropped",
    "axis_full_grid",
    "axis_minimum_scale",
    "axis_edge_infinite",
    "axis_edge_subnormal",
    "estimate_one_coarser",
    "estimate_minimum_scale",
    "decode_full_span",
    "decode_inverted",
    "decode_beyond_exactness",
    "decode_scale_below_minimum",
    "decode_too_wide",
    "coarsen_rounds_up",
    "child_scale_changed",
    "child_lower_changed",
    "stack_overflow",
    "stack_underflow",
    "collector_row_output",
    "collector_queue_full",
    "collector_flush",
    "backtrack_recurses",
    "backtrack_both_children",
    "backtrack_stops",
    "combiner_merges",
    "combiner_flushes_for_read",
    "stream_single_pair",
    "stream_stops_on_error",
    "writer_evicts",
    "writer_completes",
    "writer_forwards",
    "primitive_not_finite",
    "morton_quarter",
    "morton_flat",
    "sorter_next_run",
    "gatherer_misses",
    "walker_refuses",
    "top_down_parks",
    "emitter_joins_leaf",
    "emitter_closes_several",
    "emitter_single_leaf",
    "merger_tie",
    "merger_waits",
    "merger_half_line",
    "merger_rewrites",
    "ray_full_span",
    "ray_inverted",
    "ray_scale_below_minimum",
    "ray_too_wide",
    "ray_not_finite",
    "ray_beside_box",
    "ray_second_first",
    "ray_drops_waiting",
    "ray_leaf_crosses_lines",
    "ray_stack_overflow",
    "setup_not_finite",
    "setup_inverted",
    "setup_parallel",
    "setup_backwards",
    "directed_subnormal",
    "directed_beyond_largest",
};

/// The combinational functions of the design. Each announces itself when it starts, so that an observing bit type can
/// tell one's operators from another's.
enum class Datapath : std::uint8_t {
  compress_axis,
  estimate_scale,
  union_axis,
  choose_context,
  assemble_pair,
  reencode,
  invalidates,
  primitive_box,
  morton_frame,
  morton_code,
  unite_boxes,
  common_prefix,
  merge_compare,
  decode_box,
  ray_setup,
  intersect_pair,
  count
};

constexpr std::size_t kDatapaths = static_cast<std::size_t>(Datapath::count);

constexpr std::array<std::string_view, kDatapaths> kDatapathNames = {
    "compress_axis", "estimate_scale", "union_axis",   "choose_context", "assemble_pair", "reencode",
    "invalidates",   "primitive_box",  "morton_frame", "morton_code",    "unite_boxes",   "common_prefix",
    "merge_compare", "decode_box",     "ray_setup",    "intersect_pair"};

}  // namespace cbvh::rtl
