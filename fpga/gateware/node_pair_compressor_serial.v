// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Compresses a node pair with one scale estimator and one axis compressor that take turns over the axes: for small
// FPGAs. Latency 14, initiation interval 14. Twin of rtl_model/compress/serial_node_pair_compressor.h.
`include "cbvh_constants.vh"
module node_pair_compressor_serial #(
    parameter N = 6
) (
    input  wire                               clk,
    input  wire                               reset,
    input  wire                               jobs_valid,
    output wire                               jobs_ready,
    input  wire [   `CBVH_PAIR_JOB_WIDTH-1:0] jobs_data,
    output wire                               results_valid,
    input  wire                               results_ready,
    output wire [`CBVH_PAIR_RESULT_WIDTH-1:0] results_data
);
  reg busy;
  reg [`CBVH_PAIR_JOB_WIDTH-1:0] job;
  reg [3:0] issued;  // jobs given to the parts: three estimates, then six axes
  reg [1:0] estimates_taken;
  reg [2:0] axes_taken;
  assign jobs_ready = ~busy;
  wire start = jobs_valid & ~busy;

  // The three estimates, the first in the very cycle the job is taken. The channels inside never fill.
  wire [1:0] estimate_axis = busy ? issued[1:0] : 2'd0;
  wire [6:0] estimate_bit = {estimate_axis, 5'd0};
  wire [95:0] left_lower = busy ? job[`CBVH_PAIR_JOB_PAIR_BOX_0_LOWER] : jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_0_LOWER];
  wire [95:0] left_upper = busy ? job[`CBVH_PAIR_JOB_PAIR_BOX_0_UPPER] : jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_0_UPPER];
  wire [95:0] right_lower = busy ? job[`CBVH_PAIR_JOB_PAIR_BOX_1_LOWER] : jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_1_LOWER];
  wire [95:0] right_upper = busy ? job[`CBVH_PAIR_JOB_PAIR_BOX_1_UPPER] : jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_1_UPPER];
  wire issue_estimate = start | (busy & (issued < 4'd3));
  wire [31:0] union_lower, union_upper;
  union_axis both_children (
      .left_lower(left_lower[estimate_bit+:32]),
      .left_upper(left_upper[estimate_bit+:32]),
      .right_lower(right_lower[estimate_bit+:32]),
      .right_upper(right_upper[estimate_bit+:32]),
      .lower(union_lower),
      .upper(union_upper)
  );
  wire [`CBVH_ESTIMATE_JOB_WIDTH-1:0] estimate_job;
  assign estimate_job[`CBVH_ESTIMATE_JOB_LOWER] = union_lower;
  assign estimate_job[`CBVH_ESTIMATE_JOB_UPPER] = union_upper;
  assign estimate_job[`CBVH_ESTIMATE_JOB_REGISTERS] =
      busy ? job[`CBVH_PAIR_JOB_REGISTERS] : jobs_data[`CBVH_PAIR_JOB_REGISTERS];
  wire estimator_valid, estimator_ready, unused_estimate_jobs_ready;
  wire [`CBVH_ESTIMATE_JOB_WIDTH-1:0] estimator_data;
  skid_buffer #(
      .WIDTH(`CBVH_ESTIMATE_JOB_WIDTH)
  ) estimate_jobs (
      .clk(clk),
      .reset(reset),
      .in_valid(issue_estimate),
      .in_ready(unused_estimate_jobs_ready),
      .in_data(estimate_job),
      .out_valid(estimator_valid),
      .out_ready(estimator_ready),
      .out_data(estimator_data)
  );
  wire estimated_valid, estimated_ready, estimate_valid;
  wire [`CBVH_ESTIMATE_RESULT_WIDTH-1:0] estimated_data;
  wire [`CBVH_ESTIMATE_RESULT_WIDTH-1:0] estimate;
  scale_estimator #(
      .N(N)
  ) estimator (
      .clk(clk),
      .reset(reset),
      .jobs_valid(estimator_valid),
      .jobs_ready(estimator_ready),
      .jobs_data(estimator_data),
      .results_valid(estimated_valid),
      .results_ready(estimated_ready),
      .results_data(estimated_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_ESTIMATE_RESULT_WIDTH)
  ) estimate_results (
      .clk(clk),
      .reset(reset),
      .in_valid(estimated_valid),
      .in_ready(estimated_ready),
      .in_data(estimated_data),
      .out_valid(estimate_valid),
      .out_ready(1'b1),
      .out_data(estimate)
  );
  // The axis compressor finds the same reasons.
  wire [`CBVH_STATUS_BITS-1:0] unused_status = estimate[`CBVH_ESTIMATE_RESULT_STATUS];
  wire [1:0] estimates_taken_next = estimates_taken + {1'b0, estimate_valid};
  wire [`CBVH_AXIS_CONTEXT_WIDTH-1:0] own;
  assign own[`CBVH_AXIS_CONTEXT_SCALE] = estimate[`CBVH_ESTIMATE_RESULT_SCALE];
  assign own[`CBVH_AXIS_CONTEXT_LOWER] = estimate[`CBVH_ESTIMATE_RESULT_LOWER];
  reg [`CBVH_CONTEXT_WIDTH-1:0] estimates;
  wire [`CBVH_CONTEXT_WIDTH-1:0] estimates_next;
  genvar axis;
  generate
    for (axis = 0; axis < 3; axis = axis + 1) begin : each_estimate
      assign estimates_next[`CBVH_AXIS_CONTEXT_WIDTH*axis+:`CBVH_AXIS_CONTEXT_WIDTH] =
          estimate_valid & (estimates_taken == axis) ? own :
          estimates[`CBVH_AXIS_CONTEXT_WIDTH*axis+:`CBVH_AXIS_CONTEXT_WIDTH];
    end
  endgenerate
  wire [`CBVH_CONTEXT_WIDTH-1:0] parents =
      job[`CBVH_PAIR_JOB_GIVEN_CONTEXT] ? job[`CBVH_PAIR_JOB_CONTEXT] : estimates_next;

  // Both children on each axis, from the cycle in which its estimate is there.
  wire [2:0] turn = issued[2:0] - 3'd3;
  wire [1:0] axis_axis = turn[2:1];
  wire [2:0] axis_slot = {1'b0, axis_axis} + (turn[0] ? 3'd3 : 3'd0);
  wire issue_axis = busy & (issued >= 4'd3) & (issued < 4'd9) & (estimates_taken_next > axis_axis);
  wire [191:0] lower = {job[`CBVH_PAIR_JOB_PAIR_BOX_1_LOWER], job[`CBVH_PAIR_JOB_PAIR_BOX_0_LOWER]};
  wire [191:0] upper = {job[`CBVH_PAIR_JOB_PAIR_BOX_1_UPPER], job[`CBVH_PAIR_JOB_PAIR_BOX_0_UPPER]};
  reg [`CBVH_AXIS_CONTEXT_WIDTH-1:0] parent;
  always @(*) begin
    case (axis_axis)
      2'd0: parent = parents[`CBVH_CONTEXT_X];
      2'd1: parent = parents[`CBVH_CONTEXT_Y];
      default: parent = parents[`CBVH_CONTEXT_Z];
    endcase
  end
  wire [`CBVH_INDEX_BITS-1:0] unused_lower = parent[`CBVH_AXIS_CONTEXT_LOWER];
  wire [`CBVH_AXIS_JOB_WIDTH-1:0] axis_job;
  assign axis_job[`CBVH_AXIS_JOB_LOWER] = lower[{axis_slot, 5'd0}+:32];
  assign axis_job[`CBVH_AXIS_JOB_UPPER] = upper[{axis_slot, 5'd0}+:32];
  assign axis_job[`CBVH_AXIS_JOB_SCALE] = parent[`CBVH_AXIS_CONTEXT_SCALE];
  assign axis_job[`CBVH_AXIS_JOB_REGISTERS] = job[`CBVH_PAIR_JOB_REGISTERS];
  wire compressor_valid, compressor_ready, unused_axis_jobs_ready;
  wire [`CBVH_AXIS_JOB_WIDTH-1:0] compressor_data;
  skid_buffer #(
      .WIDTH(`CBVH_AXIS_JOB_WIDTH)
  ) axis_jobs (
      .clk(clk),
      .reset(reset),
      .in_valid(issue_axis),
      .in_ready(unused_axis_jobs_ready),
      .in_data(axis_job),
      .out_valid(compressor_valid),
      .out_ready(compressor_ready),
      .out_data(compressor_data)
  );
  wire compressed_valid, compressed_ready, axis_valid;
  wire [`CBVH_AXIS_RESULT_WIDTH-1:0] compressed_data;
  wire [`CBVH_AXIS_RESULT_WIDTH-1:0] axis_result;
  axis_compressor #(
      .N(N)
  ) compressor (
      .clk(clk),
      .reset(reset),
      .jobs_valid(compressor_valid),
      .jobs_ready(compressor_ready),
      .jobs_data(compressor_data),
      .results_valid(compressed_valid),
      .results_ready(compressed_ready),
      .results_data(compressed_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_AXIS_RESULT_WIDTH)
  ) axis_results (
      .clk(clk),
      .reset(reset),
      .in_valid(compressed_valid),
      .in_ready(compressed_ready),
      .in_data(compressed_data),
      .out_valid(axis_valid),
      .out_ready(1'b1),
      .out_data(axis_result)
  );

  // They come back x of both children, y, z: the newest is the last.
  wire [2:0] axes_taken_next = axes_taken + {2'd0, axis_valid};
  reg [6*`CBVH_AXIS_RESULT_WIDTH-1:0] axes;
  wire [6*`CBVH_AXIS_RESULT_WIDTH-1:0] axes_next =
      axis_valid ? {axis_result, axes[6*`CBVH_AXIS_RESULT_WIDTH-1:`CBVH_AXIS_RESULT_WIDTH]} : axes;
  assign results_valid = busy & (axes_taken_next == 3'd6);
  assemble_pair #(
      .N(N)
  ) assembly (
      .relative(job[`CBVH_PAIR_JOB_REGISTERS_RELATIVE]),
      .leaf(job[`CBVH_PAIR_JOB_PAIR_LEAF]),
      .pointer(job[`CBVH_PAIR_JOB_PAIR_POINTER]),
      .parents(parents),
      .axes({
        axes_next[5*`CBVH_AXIS_RESULT_WIDTH+:`CBVH_AXIS_RESULT_WIDTH],
        axes_next[3*`CBVH_AXIS_RESULT_WIDTH+:`CBVH_AXIS_RESULT_WIDTH],
        axes_next[1*`CBVH_AXIS_RESULT_WIDTH+:`CBVH_AXIS_RESULT_WIDTH],
        axes_next[4*`CBVH_AXIS_RESULT_WIDTH+:`CBVH_AXIS_RESULT_WIDTH],
        axes_next[2*`CBVH_AXIS_RESULT_WIDTH+:`CBVH_AXIS_RESULT_WIDTH],
        axes_next[0*`CBVH_AXIS_RESULT_WIDTH+:`CBVH_AXIS_RESULT_WIDTH]
      }),
      .result(results_data)
  );

  always @(posedge clk) begin
    estimates <= estimates_next;
    axes      <= axes_next;
    if (start) job <= jobs_data;
    if (reset) busy <= 1'b0;
    else busy <= busy ? ~(results_valid & results_ready) : start;
    if (start) begin
      issued          <= 4'd1;
      estimates_taken <= 2'd0;
      axes_taken      <= 3'd0;
    end else begin
      issued          <= issued + {3'd0, issue_estimate | issue_axis};
      estimates_taken <= estimates_taken_next;
      axes_taken      <= axes_taken_next;
    end
  end
endmodule
