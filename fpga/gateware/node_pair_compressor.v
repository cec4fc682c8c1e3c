// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Compresses a node pair a clock: three scale estimators, a register, six axis compressors. Latency 6, initiation
// interval 1: five registers here, the sixth is the channel behind `results`; when that is full the whole pipe holds.
// Twin of rtl_model/compress/node_pair_compressor.h; paper section 4.2.1.
`include "cbvh_constants.vh"
module node_pair_compressor #(
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
  assign jobs_ready = results_ready;

  // Stages 1 to 3: the estimate of each axis, and the job beside it.
  reg [`CBVH_PAIR_JOB_WIDTH-1:0] job_1;
  reg [`CBVH_PAIR_JOB_WIDTH-1:0] job_2;
  reg [`CBVH_PAIR_JOB_WIDTH-1:0] job_3;
  reg valid_3;
  reg [`CBVH_CONTEXT_WIDTH-1:0] context_3;
  wire [`CBVH_CONTEXT_WIDTH-1:0] estimated;
  wire [2:0] estimates_valid;
  wire [95:0] left_lower = jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_0_LOWER];
  wire [95:0] left_upper = jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_0_UPPER];
  wire [95:0] right_lower = jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_1_LOWER];
  wire [95:0] right_upper = jobs_data[`CBVH_PAIR_JOB_PAIR_BOX_1_UPPER];
  genvar axis;
  generate
    for (axis = 0; axis < 3; axis = axis + 1) begin : each_estimate
      wire [31:0] lower, upper;
      union_axis both_children (
          .left_lower(left_lower[32*axis+:32]),
          .left_upper(left_upper[32*axis+:32]),
          .right_lower(right_lower[32*axis+:32]),
          .right_upper(right_upper[32*axis+:32]),
          .lower(lower),
          .upper(upper)
      );
      wire [`CBVH_ESTIMATE_JOB_WIDTH-1:0] job;
      assign job[`CBVH_ESTIMATE_JOB_LOWER] = lower;
      assign job[`CBVH_ESTIMATE_JOB_UPPER] = upper;
      assign job[`CBVH_ESTIMATE_JOB_REGISTERS] = jobs_data[`CBVH_PAIR_JOB_REGISTERS];
      wire [`CBVH_ESTIMATE_RESULT_WIDTH-1:0] estimate;
      wire unused_ready;
      scale_estimator #(
          .N(N)
      ) estimator (
          .clk(clk),
          .reset(reset),
          .jobs_valid(jobs_valid),
          .jobs_ready(unused_ready),
          .jobs_data(job),
          .results_valid(estimates_valid[axis]),
          .results_ready(results_ready),
          .results_data(estimate)
      );
      wire [`CBVH_AXIS_CONTEXT_WIDTH-1:0] own;
      assign own[`CBVH_AXIS_CONTEXT_SCALE] = estimate[`CBVH_ESTIMATE_RESULT_SCALE];
      assign own[`CBVH_AXIS_CONTEXT_LOWER] = estimate[`CBVH_ESTIMATE_RESULT_LOWER];
      assign estimated[`CBVH_AXIS_CONTEXT_WIDTH*axis+:`CBVH_AXIS_CONTEXT_WIDTH] = own;
      // The axis compressors find the same reasons.
      wire [`CBVH_STATUS_BITS-1:0] unused_status = estimate[`CBVH_ESTIMATE_RESULT_STATUS];
    end
  endgenerate
  wire [1:0] unused_estimates_valid = estimates_valid[2:1];  // they move together

  // Stages 4 to 6: the axes of both children on that grid.
  reg [`CBVH_CONTEXT_WIDTH-1:0] context_4, context_5;
  reg [1:0] leaf_4, leaf_5;
  reg [2*`CBVH_POINTER_BITS-1:0] pointer_4, pointer_5;
  reg relative_4, relative_5;
  wire [5:0] axes_valid;
  wire [6*`CBVH_AXIS_RESULT_WIDTH-1:0] axes;
  wire [191:0] lower_3 = {job_3[`CBVH_PAIR_JOB_PAIR_BOX_1_LOWER], job_3[`CBVH_PAIR_JOB_PAIR_BOX_0_LOWER]};
  wire [191:0] upper_3 = {job_3[`CBVH_PAIR_JOB_PAIR_BOX_1_UPPER], job_3[`CBVH_PAIR_JOB_PAIR_BOX_0_UPPER]};
  wire unused_given = &{job_3[`CBVH_PAIR_JOB_GIVEN_CONTEXT], job_3[`CBVH_PAIR_JOB_CONTEXT]};
  genvar slot;
  generate
    for (slot = 0; slot < 6; slot = slot + 1) begin : each_axis
      wire [`CBVH_AXIS_CONTEXT_WIDTH-1:0] parent =
          context_3[`CBVH_AXIS_CONTEXT_WIDTH*(slot%3)+:`CBVH_AXIS_CONTEXT_WIDTH];
      wire [`CBVH_INDEX_BITS-1:0] unused_lower = parent[`CBVH_AXIS_CONTEXT_LOWER];
      wire [`CBVH_AXIS_JOB_WIDTH-1:0] job;
      assign job[`CBVH_AXIS_JOB_LOWER] = lower_3[32*slot+:32];
      assign job[`CBVH_AXIS_JOB_UPPER] = upper_3[32*slot+:32];
      assign job[`CBVH_AXIS_JOB_SCALE] = parent[`CBVH_AXIS_CONTEXT_SCALE];
      assign job[`CBVH_AXIS_JOB_REGISTERS] = job_3[`CBVH_PAIR_JOB_REGISTERS];
      wire unused_ready;
      axis_compressor #(
          .N(N)
      ) compressor (
          .clk(clk),
          .reset(reset),
          .jobs_valid(valid_3),
          .jobs_ready(unused_ready),
          .jobs_data(job),
          .results_valid(axes_valid[slot]),
          .results_ready(results_ready),
          .results_data(axes[`CBVH_AXIS_RESULT_WIDTH*slot+:`CBVH_AXIS_RESULT_WIDTH])
      );
    end
  endgenerate
  wire [4:0] unused_axes_valid = axes_valid[5:1];  // they move together
  assign results_valid = axes_valid[0];
  assemble_pair #(
      .N(N)
  ) assembly (
      .relative(relative_5),
      .leaf(leaf_5),
      .pointer(pointer_5),
      .parents(context_5),
      .axes(axes),
      .result(results_data)
  );

  always @(posedge clk) begin
    if (results_ready) begin
      job_1      <= jobs_data;
      job_2      <= job_1;
      job_3      <= job_2;
      context_3  <= job_2[`CBVH_PAIR_JOB_GIVEN_CONTEXT] ? job_2[`CBVH_PAIR_JOB_CONTEXT] : estimated;
      context_4  <= context_3;
      context_5  <= context_4;
      leaf_4     <= job_3[`CBVH_PAIR_JOB_PAIR_LEAF];
      leaf_5     <= leaf_4;
      pointer_4  <= job_3[`CBVH_PAIR_JOB_PAIR_POINTER];
      pointer_5  <= pointer_4;
      relative_4 <= job_3[`CBVH_PAIR_JOB_REGISTERS_RELATIVE];
      relative_5 <= relative_4;
    end
    if (reset) valid_3 <= 1'b0;
    else if (results_ready) valid_3 <= estimates_valid[0];
  end
endmodule
