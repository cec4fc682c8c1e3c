// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Compresses one axis of one child a clock. Latency 3, initiation interval 1: two registers here, the third is the
// channel behind `results`; when that is full the whole pipe holds. Twin of rtl_model/compress/axis_compressor.h;
// paper fig. 5 and 6.
`include "cbvh_constants.vh"
module axis_compressor #(
    parameter N = 6
) (
    input  wire                               clk,
    input  wire                               reset,
    input  wire                               jobs_valid,
    output wire                               jobs_ready,
    input  wire [  `CBVH_AXIS_JOB_WIDTH-1:0] jobs_data,
    output wire                               results_valid,
    input  wire                               results_ready,
    output wire [`CBVH_AXIS_RESULT_WIDTH-1:0] results_data
);
  wire unused_relative = jobs_data[`CBVH_AXIS_JOB_REGISTERS_RELATIVE];  // codes are always modulo here
  assign jobs_ready = results_ready;

  // Stage 1: both bounds become cell indices.
  wire signed [`CBVH_SCALE_BITS-1:0] job_scale = jobs_data[`CBVH_AXIS_JOB_SCALE];
  wire signed [`CBVH_SCALE_BITS-1:0] job_min_scale = jobs_data[`CBVH_AXIS_JOB_REGISTERS_MIN_SCALE];
  wire signed [`CBVH_INDEX_BITS-1:0] lower_floor, upper_floor;
  wire [`CBVH_STATUS_BITS-1:0] interval;
  interval_cells bounds (
      .lower(jobs_data[`CBVH_AXIS_JOB_LOWER]),
      .upper(jobs_data[`CBVH_AXIS_JOB_UPPER]),
      .scale(job_scale),
      .min_scale(job_min_scale),
      .lower_floor(lower_floor),
      .upper_floor(upper_floor),
      .status(interval)
  );

  reg                               valid_1;
  reg signed [`CBVH_INDEX_BITS-1:0] lower_1;
  reg signed [`CBVH_INDEX_BITS-1:0] upper_floor_1;
  reg signed [`CBVH_SCALE_BITS-1:0] scale_1;
  reg signed [`CBVH_SCALE_BITS-1:0] min_scale_1;
  reg                               figure5_1;
  reg        [`CBVH_STATUS_BITS-1:0] interval_1;

  // Stage 2: the size in cells gives the own grid. The +1 of the upper bound is not needed for that.
  wire signed [`CBVH_INDEX_BITS:0] difference = upper_floor_1 - lower_1;
  wire [N-1:0] size = difference[N-1:0];
  wire [3:0] finer;
  leading_zeros #(
      .WIDTH(N),
      .BITS (4)
  ) refinement (
      .value(figure5_1 ? size + 1'b1 : size),
      .zeros(finer)
  );
  wire signed [`CBVH_SCALE_BITS:0] wanted = scale_1 - $signed({6'd0, finer});
  wire held = wanted < $signed({min_scale_1[`CBVH_SCALE_BITS-1], min_scale_1});
  wire signed [`CBVH_SCALE_BITS-1:0] own_scale = held ? min_scale_1 : wanted[`CBVH_SCALE_BITS-1:0];
  wire [3:0] own_shift = scale_1[3:0] - own_scale[3:0];
  wire below = scale_1 < min_scale_1;
  wire wide = difference[`CBVH_INDEX_BITS] ? 1'b0 : (|difference[`CBVH_INDEX_BITS-1:N]) | (figure5_1 & (&size));

  reg                                valid_2;
  reg signed [ `CBVH_INDEX_BITS-1:0] lower_2;
  reg signed [ `CBVH_INDEX_BITS-1:0] upper_2;
  reg signed [ `CBVH_SCALE_BITS-1:0] scale_2;
  reg signed [ `CBVH_SCALE_BITS-1:0] own_scale_2;
  reg signed [ `CBVH_INDEX_BITS-1:0] own_lower_2;
  reg        [`CBVH_STATUS_BITS-1:0] status_2;

  // Stage 3: decoded bounds. Of a refused job everything but the reason is zero.
  wire [31:0] edge_lo, edge_hi;
  pack_float pack_lower (
      .index(lower_2),
      .scale(scale_2),
      .value(edge_lo)
  );
  pack_float pack_upper (
      .index(upper_2),
      .scale(scale_2),
      .value(edge_hi)
  );
  wire accepted = status_2 == `CBVH_STATUS_OK;
  assign results_valid = valid_2;
  assign results_data[`CBVH_AXIS_RESULT_CODE_LO] = lower_2[N-1:0] & {N{accepted}};
  assign results_data[`CBVH_AXIS_RESULT_CODE_HI] = upper_2[N-1:0] & {N{accepted}};
  assign results_data[`CBVH_AXIS_RESULT_OWN_SCALE] = own_scale_2 & {`CBVH_SCALE_BITS{accepted}};
  assign results_data[`CBVH_AXIS_RESULT_OWN_LOWER] = own_lower_2 & {`CBVH_INDEX_BITS{accepted}};
  assign results_data[`CBVH_AXIS_RESULT_EDGE_LO] = edge_lo & {32{accepted}};
  assign results_data[`CBVH_AXIS_RESULT_EDGE_HI] = edge_hi & {32{accepted}};
  assign results_data[`CBVH_AXIS_RESULT_STATUS] = status_2;

  always @(posedge clk) begin
    if (results_ready) begin
      lower_1       <= lower_floor;
      upper_floor_1 <= upper_floor;
      scale_1       <= job_scale;
      min_scale_1   <= job_min_scale;
      figure5_1     <= jobs_data[`CBVH_AXIS_JOB_REGISTERS_FIGURE5];
      interval_1    <= interval;
      lower_2       <= lower_1;
      upper_2       <= upper_floor_1 + 26'sd1;
      scale_2       <= scale_1;
      own_scale_2   <= own_scale;
      own_lower_2   <= lower_1 << own_shift;
      status_2      <= interval_1 != `CBVH_STATUS_OK ? interval_1 :
                       below ? `CBVH_STATUS_SCALE_BELOW_MINIMUM :
                       wide ? `CBVH_STATUS_TOO_WIDE : `CBVH_STATUS_OK;
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
