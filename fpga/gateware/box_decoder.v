// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Decodes one child of a stored pair a clock. Latency 3, initiation interval 1: two registers here, the third is the
// channel behind `results`; when that is full the whole pipe holds. Twin of rtl_model/traverse/box_decoder.h; paper
// fig. 4, equations 3 and 9.
`include "cbvh_constants.vh"
module box_decoder #(
    parameter N = 6
) (
    input  wire                                 clk,
    input  wire                                 reset,
    input  wire                                 jobs_valid,
    output wire                                 jobs_ready,
    input  wire [   `CBVH_DECODE_JOB_WIDTH-1:0] jobs_data,
    output wire                                 results_valid,
    input  wire                                 results_ready,
    output wire [`CBVH_DECODE_RESULT_WIDTH-1:0] results_data
);
  assign jobs_ready = results_ready;
  wire [            3*N-1:0] lo = jobs_data[`CBVH_DECODE_JOB_NODE_LO];
  wire [            3*N-1:0] hi = jobs_data[`CBVH_DECODE_JOB_NODE_HI];
  wire [`CBVH_CONTEXT_WIDTH-1:0] parents = jobs_data[`CBVH_DECODE_JOB_PARENT];

  // What the axes share.
  reg                                valid_1, valid_2;
  reg signed [ `CBVH_SCALE_BITS-1:0] min_scale_1;
  reg                                figure5_1;
  reg                                leaf_1, leaf_2;
  reg        [`CBVH_POINTER_BITS-1:0] pointer_1, pointer_2;
  reg        [ `CBVH_STATUS_BITS-1:0] status_2;
  wire       [3*`CBVH_STATUS_BITS-1:0] statuses;
  wire       [ `CBVH_STATUS_BITS-1:0] status;
  wire                               accepted = status_2 == `CBVH_STATUS_OK;
  wire [                        95:0] lower_edges, upper_edges;
  wire [      `CBVH_CONTEXT_WIDTH-1:0] own;

  genvar axis;
  generate
    for (axis = 0; axis < 3; axis = axis + 1) begin : each_axis
      // Stage 1: codes become cells on the parent's grid.
      wire [`CBVH_AXIS_CONTEXT_WIDTH-1:0] parent =
          parents[`CBVH_AXIS_CONTEXT_WIDTH*axis+:`CBVH_AXIS_CONTEXT_WIDTH];
      wire signed [`CBVH_INDEX_BITS-1:0] lower, upper;
      decode_codes #(
          .N(N)
      ) codes (
          .lo(lo[N*axis+:N]),
          .hi(hi[N*axis+:N]),
          .parent_lower(parent[`CBVH_AXIS_CONTEXT_LOWER]),
          .relative(jobs_data[`CBVH_DECODE_JOB_REGISTERS_RELATIVE]),
          .lower(lower),
          .upper(upper)
      );
      reg signed [`CBVH_INDEX_BITS-1:0] lower_1, upper_1;
      reg signed [`CBVH_SCALE_BITS-1:0] scale_1;

      // Stage 2: the own grid, and what speaks against it.
      wire [`CBVH_SCALE_BITS-1:0] own_scale;
      wire [`CBVH_INDEX_BITS-1:0] own_lower;
      decode_axis #(
          .N(N)
      ) judged (
          .lower(lower_1),
          .upper(upper_1),
          .scale(scale_1),
          .min_scale(min_scale_1),
          .figure5(figure5_1),
          .own_scale(own_scale),
          .own_lower(own_lower),
          .status(statuses[`CBVH_STATUS_BITS*axis+:`CBVH_STATUS_BITS])
      );
      reg signed [`CBVH_INDEX_BITS-1:0] lower_2, upper_2;
      reg signed [`CBVH_SCALE_BITS-1:0] scale_2;
      reg [`CBVH_SCALE_BITS-1:0] own_scale_2;
      reg [`CBVH_INDEX_BITS-1:0] own_lower_2;

      // Stage 3: the bounds in binary32.
      pack_float pack_lower (
          .index(lower_2),
          .scale(scale_2),
          .value(lower_edges[32*axis+:32])
      );
      pack_float pack_upper (
          .index(upper_2),
          .scale(scale_2),
          .value(upper_edges[32*axis+:32])
      );
      assign own[`CBVH_AXIS_CONTEXT_WIDTH*axis+:`CBVH_AXIS_CONTEXT_WIDTH] = {own_lower_2, own_scale_2};

      always @(posedge clk) begin
        if (results_ready) begin
          lower_1     <= lower;
          upper_1     <= upper;
          scale_1     <= parent[`CBVH_AXIS_CONTEXT_SCALE];
          lower_2     <= lower_1;
          upper_2     <= upper_1;
          scale_2     <= scale_1;
          own_scale_2 <= own_scale;
          own_lower_2 <= own_lower;
        end
      end
    end
  endgenerate

  // One refused axis refuses the child: everything but the reason is zero.
  first_reason #(
      .COUNT(3)
  ) refusal (
      .reasons(statuses),
      .first  (status)
  );
  assign results_valid = valid_2;
  assign results_data[`CBVH_DECODE_RESULT_BOX_LOWER] = lower_edges & {96{accepted}};
  assign results_data[`CBVH_DECODE_RESULT_BOX_UPPER] = upper_edges & {96{accepted}};
  assign results_data[`CBVH_DECODE_RESULT_CONTEXT] = own & {`CBVH_CONTEXT_WIDTH{accepted}};
  assign results_data[`CBVH_DECODE_RESULT_LEAF] = leaf_2 & accepted;
  assign results_data[`CBVH_DECODE_RESULT_POINTER] = pointer_2 & {`CBVH_POINTER_BITS{accepted}};
  assign results_data[`CBVH_DECODE_RESULT_STATUS] = status_2;

  always @(posedge clk) begin
    if (results_ready) begin
      min_scale_1 <= jobs_data[`CBVH_DECODE_JOB_REGISTERS_MIN_SCALE];
      figure5_1   <= jobs_data[`CBVH_DECODE_JOB_REGISTERS_FIGURE5];
      leaf_1      <= jobs_data[`CBVH_DECODE_JOB_NODE_LEAF];
      pointer_1   <= jobs_data[`CBVH_DECODE_JOB_NODE_POINTER];
      leaf_2      <= leaf_1;
      pointer_2   <= pointer_1;
      status_2    <= status;
    end
    if (reset) begin
      valid_1 <= 1'b0;
      valid_2 <= 1'b0;
    end else if (results_ready) begin
      valid_1 <= jobs_valid;
      valid_2 <= valid_1;
    end
  end
endmodule
