// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// One child of a stored pair, re-encoded for another context of its pair, and the child's own context before and after.
// Combinational. Twin of reencode in rtl_model/datapath/reencode.h, of which a pair has two; paper algorithm 1,
// function Backtrack.
`include "cbvh_constants.vh"
module reencode_child #(
    parameter N = 6
) (
    input  wire [    `CBVH_NODE_CODES_WIDTH-1:0] codes,
    input  wire [       `CBVH_CONTEXT_WIDTH-1:0] old_context,
    input  wire [       `CBVH_CONTEXT_WIDTH-1:0] new_context,
    input  wire [`CBVH_SCENE_REGISTERS_WIDTH-1:0] registers,
    output wire [    `CBVH_NODE_CODES_WIDTH-1:0] fixed,
    output wire [       `CBVH_CONTEXT_WIDTH-1:0] child_before,
    output wire [       `CBVH_CONTEXT_WIDTH-1:0] child_after,
    output wire                                  repair
);
  wire [N-1:0] lo_x, hi_x;
  wire [`CBVH_SCALE_BITS-1:0] scale_before_x, scale_after_x;
  wire [`CBVH_INDEX_BITS-1:0] lower_before_x, lower_after_x;
  reencode_axis #(
      .N(N)
  ) axis_x (
      .lo(codes[`CBVH_NODE_CODES_LO_X]),
      .hi(codes[`CBVH_NODE_CODES_HI_X]),
      .old_scale(old_context[`CBVH_CONTEXT_X_SCALE]),
      .old_lower(old_context[`CBVH_CONTEXT_X_LOWER]),
      .new_scale(new_context[`CBVH_CONTEXT_X_SCALE]),
      .new_lower(new_context[`CBVH_CONTEXT_X_LOWER]),
      .min_scale(registers[`CBVH_SCENE_REGISTERS_MIN_SCALE]),
      .figure5(registers[`CBVH_SCENE_REGISTERS_FIGURE5]),
      .relative(registers[`CBVH_SCENE_REGISTERS_RELATIVE]),
      .new_lo(lo_x),
      .new_hi(hi_x),
      .scale_before(scale_before_x),
      .lower_before(lower_before_x),
      .scale_after(scale_after_x),
      .lower_after(lower_after_x)
  );

  wire [N-1:0] lo_y, hi_y;
  wire [`CBVH_SCALE_BITS-1:0] scale_before_y, scale_after_y;
  wire [`CBVH_INDEX_BITS-1:0] lower_before_y, lower_after_y;
  reencode_axis #(
      .N(N)
  ) axis_y (
      .lo(codes[`CBVH_NODE_CODES_LO_Y]),
      .hi(codes[`CBVH_NODE_CODES_HI_Y]),
      .old_scale(old_context[`CBVH_CONTEXT_Y_SCALE]),
      .old_lower(old_context[`CBVH_CONTEXT_Y_LOWER]),
      .new_scale(new_context[`CBVH_CONTEXT_Y_SCALE]),
      .new_lower(new_context[`CBVH_CONTEXT_Y_LOWER]),
      .min_scale(registers[`CBVH_SCENE_REGISTERS_MIN_SCALE]),
      .figure5(registers[`CBVH_SCENE_REGISTERS_FIGURE5]),
      .relative(registers[`CBVH_SCENE_REGISTERS_RELATIVE]),
      .new_lo(lo_y),
      .new_hi(hi_y),
      .scale_before(scale_before_y),
      .lower_before(lower_before_y),
      .scale_after(scale_after_y),
      .lower_after(lower_after_y)
  );

  wire [N-1:0] lo_z, hi_z;
  wire [`CBVH_SCALE_BITS-1:0] scale_before_z, scale_after_z;
  wire [`CBVH_INDEX_BITS-1:0] lower_before_z, lower_after_z;
  reencode_axis #(
      .N(N)
  ) axis_z (
      .lo(codes[`CBVH_NODE_CODES_LO_Z]),
      .hi(codes[`CBVH_NODE_CODES_HI_Z]),
      .old_scale(old_context[`CBVH_CONTEXT_Z_SCALE]),
      .old_lower(old_context[`CBVH_CONTEXT_Z_LOWER]),
      .new_scale(new_context[`CBVH_CONTEXT_Z_SCALE]),
      .new_lower(new_context[`CBVH_CONTEXT_Z_LOWER]),
      .min_scale(registers[`CBVH_SCENE_REGISTERS_MIN_SCALE]),
      .figure5(registers[`CBVH_SCENE_REGISTERS_FIGURE5]),
      .relative(registers[`CBVH_SCENE_REGISTERS_RELATIVE]),
      .new_lo(lo_z),
      .new_hi(hi_z),
      .scale_before(scale_before_z),
      .lower_before(lower_before_z),
      .scale_after(scale_after_z),
      .lower_after(lower_after_z)
  );

  assign fixed = {
    codes[`CBVH_NODE_CODES_POINTER], codes[`CBVH_NODE_CODES_LEAF], hi_z, hi_y, hi_x, lo_z, lo_y, lo_x
  };
  assign child_before = {lower_before_z, scale_before_z, lower_before_y, scale_before_y, lower_before_x, scale_before_x};
  assign child_after = {lower_after_z, scale_after_z, lower_after_y, scale_after_y, lower_after_x, scale_after_x};

  wire changed;
  context_changed change (
      .old_context(child_before),
      .new_context(child_after),
      .relative(registers[`CBVH_SCENE_REGISTERS_RELATIVE]),
      .changed(changed)
  );
  assign repair = changed & ~codes[`CBVH_NODE_CODES_LEAF];
endmodule
