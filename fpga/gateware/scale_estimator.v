// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Estimates the grid of one axis of a node a clock, before its parent is known. Latency 3, initiation interval 1: two
// registers here, the third is the channel behind `results`. Twin of rtl_model/compress/scale_estimator.h; rule 6.
`include "cbvh_constants.vh"
module scale_estimator #(
    parameter N = 6
) (
    input  wire                                   clk,
    input  wire                                   reset,
    input  wire                                   jobs_valid,
    output wire                                   jobs_ready,
    input  wire [   `CBVH_ESTIMATE_JOB_WIDTH-1:0] jobs_data,
    output wire                                   results_valid,
    input  wire                                   results_ready,
    output wire [`CBVH_ESTIMATE_RESULT_WIDTH-1:0] results_data
);
  wire unused_relative = jobs_data[`CBVH_ESTIMATE_JOB_REGISTERS_RELATIVE];  // no codes here
  assign jobs_ready = results_ready;

  // Stage 1: both bounds become indices on the grid of the minimum scale, where nothing is lost.
  wire signed [`CBVH_SCALE_BITS-1:0] job_min_scale = jobs_data[`CBVH_ESTIMATE_JOB_REGISTERS_MIN_SCALE];
  wire signed [`CBVH_INDEX_BITS-1:0] lower_floor, upper_floor;
  wire [`CBVH_STATUS_BITS-1:0] interval;
  interval_cells bounds (
      .lower(jobs_data[`CBVH_ESTIMATE_JOB_LOWER]),
      .upper(jobs_data[`CBVH_ESTIMATE_JOB_UPPER]),
      .scale(job_min_scale),
      .min_scale(job_min_scale),
      .lower_floor(lower_floor),
      .upper_floor(upper_floor),
      .status(interval)
  );

  reg                                valid_1;
  reg signed [ `CBVH_INDEX_BITS-1:0] lower_1;
  reg signed [ `CBVH_INDEX_BITS-1:0] upper_floor_1;
  reg signed [ `CBVH_SCALE_BITS-1:0] min_scale_1;
  reg                                figure5_1;
  reg        [`CBVH_STATUS_BITS-1:0] status_1;

  // Stage 2: the scale at which the size alone has N bits: the bit length of the size, less N, but not below 0.
  wire [`CBVH_INDEX_BITS-1:0] size = upper_floor_1 - lower_1;
  wire [4:0] zeros;
  leading_zeros #(
      .WIDTH(`CBVH_INDEX_BITS),
      .BITS (5)
  ) length (
      .value(size),
      .zeros(zeros)
  );
  localparam [31:0] LEAST_ZEROS = `CBVH_INDEX_BITS - N;
  wire [5:0] excess = LEAST_ZEROS[5:0] - {1'b0, zeros};

  reg                                valid_2;
  reg signed [ `CBVH_INDEX_BITS-1:0] lower_2;
  reg signed [ `CBVH_INDEX_BITS-1:0] upper_floor_2;
  reg signed [ `CBVH_SCALE_BITS-1:0] min_scale_2;
  reg        [                  4:0] fine_2;
  reg                                figure5_2;
  reg        [`CBVH_STATUS_BITS-1:0] status_2;

  // Stage 3: that scale is right, or one too fine. Of a refused job everything but the reason is zero.
  wire signed [`CBVH_INDEX_BITS-1:0] upper_cell = upper_floor_2 >>> fine_2;
  wire signed [`CBVH_INDEX_BITS-1:0] lower_cell = lower_2 >>> fine_2;
  wire signed [`CBVH_INDEX_BITS:0] difference = upper_cell - lower_cell;
  wire too_fine = difference[`CBVH_INDEX_BITS] ? 1'b0 :
                  (|difference[`CBVH_INDEX_BITS-1:N]) | (figure5_2 & (&difference[N-1:0]));
  wire accepted = status_2 == `CBVH_STATUS_OK;
  wire signed [`CBVH_INDEX_BITS-1:0] lower = too_fine ? lower_cell >>> 1 : lower_cell;
  wire [`CBVH_SCALE_BITS-1:0] scale = min_scale_2 + {4'd0, fine_2} + {8'd0, too_fine};
  assign results_valid = valid_2;
  assign results_data[`CBVH_ESTIMATE_RESULT_SCALE] = scale & {`CBVH_SCALE_BITS{accepted}};
  assign results_data[`CBVH_ESTIMATE_RESULT_LOWER] = lower & {`CBVH_INDEX_BITS{accepted}};
  assign results_data[`CBVH_ESTIMATE_RESULT_STATUS] = status_2;

  always @(posedge clk) begin
    if (results_ready) begin
      lower_1       <= lower_floor;
      upper_floor_1 <= upper_floor;
      min_scale_1   <= job_min_scale;
      figure5_1     <= jobs_data[`CBVH_ESTIMATE_JOB_REGISTERS_FIGURE5];
      status_1      <= interval;
      lower_2       <= lower_1;
      upper_floor_2 <= upper_floor_1;
      min_scale_2   <= min_scale_1;
      fine_2        <= excess[5] ? 5'd0 : excess[4:0];
      figure5_2     <= figure5_1;
      status_2      <= status_1;
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
