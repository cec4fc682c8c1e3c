// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Puts six compressed axes together: those of child 0, then those of child 1. One refused axis refuses the pair: then
// everything but the reason is zero. Combinational. Twin of assemble_pair in rtl_model/datapath/pair_compress.h.
`include "cbvh_constants.vh"
module assemble_pair #(
    parameter N = 6
) (
    input  wire                               relative,
    input  wire [                        1:0] leaf,
    input  wire [   2*`CBVH_POINTER_BITS-1:0] pointer,
    input  wire [    `CBVH_CONTEXT_WIDTH-1:0] parents,
    input  wire [6*`CBVH_AXIS_RESULT_WIDTH-1:0] axes,
    output wire [ `CBVH_PAIR_RESULT_WIDTH-1:0] result
);
  wire [6*`CBVH_STATUS_BITS-1:0] reasons;
  wire [`CBVH_STATUS_BITS-1:0] status;
  first_reason judge (
      .reasons(reasons),
      .first  (status)
  );
  wire accepted = status == `CBVH_STATUS_OK;

  wire [6*N-1:0] lo;
  wire [6*N-1:0] hi;
  wire [6*`CBVH_AXIS_CONTEXT_WIDTH-1:0] child_context;
  genvar slot;
  generate
    for (slot = 0; slot < 6; slot = slot + 1) begin : each_axis
      wire [`CBVH_AXIS_RESULT_WIDTH-1:0] axis = axes[`CBVH_AXIS_RESULT_WIDTH*slot+:`CBVH_AXIS_RESULT_WIDTH];
      wire [63:0] unused_edges = {axis[`CBVH_AXIS_RESULT_EDGE_HI], axis[`CBVH_AXIS_RESULT_EDGE_LO]};
      wire [`CBVH_AXIS_CONTEXT_WIDTH-1:0] parent = parents[`CBVH_AXIS_CONTEXT_WIDTH*(slot%3)+:`CBVH_AXIS_CONTEXT_WIDTH];
      wire [`CBVH_INDEX_BITS-1:0] parent_lower = parent[`CBVH_AXIS_CONTEXT_LOWER];
      wire [`CBVH_INDEX_BITS-N-1:0] unused_high = parent_lower[`CBVH_INDEX_BITS-1:N];
      wire [`CBVH_SCALE_BITS-1:0] unused_scale = parent[`CBVH_AXIS_CONTEXT_SCALE];
      wire [N-1:0] base = parent_lower[N-1:0] & {N{relative}};  // codes are stored relative to it: rule 5
      wire [`CBVH_AXIS_CONTEXT_WIDTH-1:0] own;
      assign own[`CBVH_AXIS_CONTEXT_SCALE] = axis[`CBVH_AXIS_RESULT_OWN_SCALE];
      assign own[`CBVH_AXIS_CONTEXT_LOWER] = axis[`CBVH_AXIS_RESULT_OWN_LOWER];
      assign reasons[`CBVH_STATUS_BITS*slot+:`CBVH_STATUS_BITS] = axis[`CBVH_AXIS_RESULT_STATUS];
      assign lo[N*slot+:N] = (axis[`CBVH_AXIS_RESULT_CODE_LO] - base) & {N{accepted}};
      assign hi[N*slot+:N] = (axis[`CBVH_AXIS_RESULT_CODE_HI] - base) & {N{accepted}};
      assign child_context[`CBVH_AXIS_CONTEXT_WIDTH*slot+:`CBVH_AXIS_CONTEXT_WIDTH] =
          own & {`CBVH_AXIS_CONTEXT_WIDTH{accepted}};
    end
  endgenerate

  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_0_LO] = lo[3*N-1:0];
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_0_HI] = hi[3*N-1:0];
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_0_LEAF] = leaf[0] & accepted;
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_0_POINTER] =
      pointer[0+:`CBVH_POINTER_BITS] & {`CBVH_POINTER_BITS{accepted}};
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_1_LO] = lo[6*N-1:3*N];
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_1_HI] = hi[6*N-1:3*N];
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_1_LEAF] = leaf[1] & accepted;
  assign result[`CBVH_PAIR_RESULT_PAIR_CHILD_1_POINTER] =
      pointer[`CBVH_POINTER_BITS+:`CBVH_POINTER_BITS] & {`CBVH_POINTER_BITS{accepted}};
  assign result[`CBVH_PAIR_RESULT_CONTEXT] = parents & {`CBVH_CONTEXT_WIDTH{accepted}};
  assign result[`CBVH_PAIR_RESULT_CHILD_CONTEXT] = child_context;
  assign result[`CBVH_PAIR_RESULT_STATUS] = status;
endmodule
