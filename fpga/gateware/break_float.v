// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A binary32 taken apart: its magnitude is mantissa * 2^place. `key` orders like the number does; -0 equals 0.
// Combinational. Twin of rtl_model/datapath/float_fields.h; paper fig. 5, lines 1-5.
`include "cbvh_constants.vh"
module break_float (
    input  wire        [                31:0] value,
    output wire                               sign,
    output wire        [                23:0] mantissa,
    output wire signed [`CBVH_SCALE_BITS-1:0] place,
    output wire                               special,
    output wire signed [                31:0] key
);
  wire [7:0] exponent = value[30:23];
  wire       normal = |exponent;
  wire [8:0] effective = {1'b0, exponent[7:1], exponent[0] | ~normal};

  assign sign     = value[31];
  assign mantissa = {normal, value[22:0]};
  assign place    = effective - 9'd150;
  assign special  = &exponent;
  assign key      = value[31] ? 32'd0 - {1'b0, value[30:0]} : {1'b0, value[30:0]};
endmodule
