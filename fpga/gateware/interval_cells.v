// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Both bounds of an interval as indices of cells of size 2^scale, rounded down, and why the interval is refused.
// Combinational: the first stage of axis_compressor, and of scale_estimator on the grid of the minimum scale. Calls of
// rtl_model/datapath/: break_float, cell_floor, interval_status.
`include "cbvh_constants.vh"
module interval_cells (
    input  wire        [                31:0] lower,
    input  wire        [                31:0] upper,
    input  wire signed [`CBVH_SCALE_BITS-1:0] scale,
    input  wire signed [`CBVH_SCALE_BITS-1:0] min_scale,
    output wire signed [`CBVH_INDEX_BITS-1:0] lower_floor,
    output wire signed [`CBVH_INDEX_BITS-1:0] upper_floor,
    output wire        [`CBVH_STATUS_BITS-1:0] status
);
  wire lower_sign, upper_sign, lower_special, upper_special;
  wire [23:0] lower_mantissa, upper_mantissa;
  wire signed [`CBVH_SCALE_BITS-1:0] lower_place, upper_place;
  wire signed [31:0] lower_key, upper_key;
  break_float break_lower (
      .value(lower),
      .sign(lower_sign),
      .mantissa(lower_mantissa),
      .place(lower_place),
      .special(lower_special),
      .key(lower_key)
  );
  break_float break_upper (
      .value(upper),
      .sign(upper_sign),
      .mantissa(upper_mantissa),
      .place(upper_place),
      .special(upper_special),
      .key(upper_key)
  );
  cell_floor floor_lower (
      .sign(lower_sign),
      .mantissa(lower_mantissa),
      .place(lower_place),
      .scale(scale),
      .index(lower_floor)
  );
  cell_floor floor_upper (
      .sign(upper_sign),
      .mantissa(upper_mantissa),
      .place(upper_place),
      .scale(scale),
      .index(upper_floor)
  );
  interval_status check (
      .lower_key(lower_key),
      .upper_key(upper_key),
      .lower_place(lower_place),
      .upper_place(upper_place),
      .lower_special(lower_special),
      .upper_special(upper_special),
      .min_scale(min_scale),
      .status(status)
  );
endmodule
