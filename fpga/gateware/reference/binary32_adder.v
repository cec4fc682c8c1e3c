// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The sum of two binary32, IEEE 754: to nearest, ties to even, with subnormals, infinities and NaN (always 7FC00000). The
// yardstick of the area table, so it has the pipeline of axis_compressor.v: two registers here, the third would be the
// channel behind `results`; the whole pipe holds when that is full.
module binary32_adder (
    input  wire        clk,
    input  wire        reset,
    input  wire        jobs_valid,
    output wire        jobs_ready,
    input  wire [63:0] jobs_data,      // two binary32
    output wire        results_valid,
    input  wire        results_ready,
    output wire [31:0] results_data
);
  assign jobs_ready = results_ready;

  // Stage 1: the smaller magnitude is aligned to the larger; three more bits, the last one for all that is shifted out.
  wire [31:0] a = jobs_data[31:0], b = jobs_data[63:32];
  wire        swap = b[30:0] > a[30:0];
  wire [31:0] x = swap ? b : a, y = swap ? a : b;
  wire        x_normal = |x[30:23], y_normal = |y[30:23];
  wire [ 7:0] x_exponent = {x[30:24], x[23] | ~x_normal}, y_exponent = {y[30:24], y[23] | ~y_normal};
  wire [ 7:0] distance = x_exponent - y_exponent;
  wire        far = distance > 8'd26;
  wire [52:0] spread = {y_normal, y[22:0], 29'd0} >> distance[4:0];
  wire [26:0] aligned = far ? {26'd0, |y[30:0]} : {spread[52:27], |spread[26:0]};
  wire        x_special = &x[30:23], y_special = &y[30:23];
  wire        x_nan = x_special & (|x[22:0]);  // of two special ones a NaN has the larger magnitude

  reg         valid_1;
  reg         sign_1, subtract_1, nan_1, infinite_1, minus_zero_1;
  reg  [ 7:0] exponent_1;
  reg  [23:0] mantissa_1;
  reg  [26:0] aligned_1;

  // Stage 2: the sum, and how far it is from normal.
  wire [27:0] operand = {1'b0, aligned_1} ^ {28{subtract_1}};
  wire [27:0] sum = {1'b0, mantissa_1, 3'd0} + operand + {27'd0, subtract_1};
  wire [ 4:0] zeros;
  leading_zeros #(
      .WIDTH(27),
      .BITS (5)
  ) length (
      .value(sum[26:0]),
      .zeros(zeros)
  );

  reg         valid_2;
  reg         sign_2, nan_2, infinite_2, minus_zero_2;
  reg  [ 7:0] exponent_2;
  reg  [27:0] sum_2;
  reg  [ 4:0] zeros_2;

  // Stage 3: normal or subnormal, rounded. A carry out of the fraction moves into the exponent by itself.
  wire        too_small = {3'd0, zeros_2} >= exponent_2;
  wire [ 4:0] up = too_small ? exponent_2[4:0] - 5'd1 : zeros_2;
  wire [26:0] shifted = sum_2[27] ? {sum_2[27:2], |sum_2[1:0]} : sum_2[26:0] << up;
  wire        unused_leading_one = shifted[26];
  wire [ 7:0] exponent = sum_2[27] ? exponent_2 + 8'd1 : too_small ? 8'd0 : exponent_2 - {3'd0, zeros_2};
  wire        round_up = shifted[2] & (shifted[3] | shifted[1] | shifted[0]);
  wire [30:0] rounded = {exponent, shifted[25:3]} + {30'd0, round_up};
  wire        infinite = infinite_2 | (&rounded[30:23]) | (&exponent);
  wire        zero = sum_2 == 28'd0;
  assign results_valid = valid_2;
  assign results_data = nan_2 ? 32'h7FC00000 :
                        infinite ? {sign_2, 31'h7F800000} :
                        zero ? {minus_zero_2, 31'd0} : {sign_2, rounded};

  always @(posedge clk) begin
    if (results_ready) begin
      sign_1       <= x[31];
      subtract_1   <= x[31] ^ y[31];
      exponent_1   <= x_exponent;
      mantissa_1   <= {x_normal, x[22:0]};
      aligned_1    <= aligned;
      nan_1        <= x_nan | (x_special & y_special & (x[31] ^ y[31]));
      infinite_1   <= x_special;
      minus_zero_1 <= x[31] & y[31];
      sign_2       <= sign_1;
      exponent_2   <= exponent_1;
      sum_2        <= sum;
      zeros_2      <= zeros;
      nan_2        <= nan_1;
      infinite_2   <= infinite_1;
      minus_zero_2 <= minus_zero_1;
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
