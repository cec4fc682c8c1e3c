// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// index * 2^scale as a binary32; exact, or infinite from 2^128 on. Combinational. Twin of pack_float in
// rtl_model/datapath/float_fields.h; paper fig. 5, lines 30-40.
`include "cbvh_constants.vh"
module pack_float (
    input  wire signed [`CBVH_INDEX_BITS-1:0] index,
    input  wire signed [`CBVH_SCALE_BITS-1:0] scale,
    output wire        [                31:0] value
);
  wire sign = index[25];
  wire [24:0] magnitude = sign ? 25'd0 - index[24:0] : index[24:0];
  wire [4:0] zeros;
  leading_zeros #(
      .WIDTH(25),
      .BITS (5)
  ) count (
      .value(magnitude),
      .zeros(zeros)
  );

  // The exponent field of a normal result: scale + 24 - zeros + 127.
  wire signed [10:0] field = {{2{scale[8]}}, scale} + (11'd151 - {6'd0, zeros});
  wire normal = ~field[10] & (|field);
  // A subnormal result has its last place at 2^-149; a normal one has its highest bit at bit 24.
  wire [4:0] to_last_place = scale[4:0] + 5'd21;
  wire [23:0] aligned = magnitude[23:0] << (normal ? zeros : to_last_place);
  wire [22:0] fraction = normal ? aligned[23:1] : aligned[22:0];
  wire zero = ~(|magnitude);
  wire infinite = ~zero & (field > 11'sd254);
  wire [7:0] exponent = normal & ~zero ? field[7:0] : 8'd0;

  assign value = {sign, infinite ? 31'h7F800000 : zero ? 31'd0 : {exponent, fraction}};
endmodule
