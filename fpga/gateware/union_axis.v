// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The box that encloses two on one axis: the smaller of the lower bounds, the larger of the upper ones. Combinational.
// Twin of union_axis in rtl_model/datapath/pair_compress.h.
module union_axis (
    input  wire [31:0] left_lower,
    input  wire [31:0] left_upper,
    input  wire [31:0] right_lower,
    input  wire [31:0] right_upper,
    output wire [31:0] lower,
    output wire [31:0] upper
);
  // A number that orders like the binary32 does; -0 equals 0.
  function signed [31:0] order_key(input [31:0] value);
    order_key = value[31] ? 32'd0 - {1'b0, value[30:0]} : {1'b0, value[30:0]};
  endfunction

  assign lower = order_key(right_lower) < order_key(left_lower) ? right_lower : left_lower;
  assign upper = order_key(left_upper) < order_key(right_upper) ? right_upper : left_upper;
endmodule
