// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// floor(x / 2^scale) as a two's complement cell index; scale is not finer than x's last place. Combinational. Twin of
// cell_floor in rtl_model/datapath/cell_index.h; paper fig. 5, lines 7-12, rounded towards minus infinity.
`include "cbvh_constants.vh"
module cell_floor (
    input  wire                               sign,
    input  wire        [                23:0] mantissa,
    input  wire signed [`CBVH_SCALE_BITS-1:0] place,
    input  wire signed [`CBVH_SCALE_BITS-1:0] scale,
    output wire signed [`CBVH_INDEX_BITS-1:0] index
);
  wire [8:0] distance = scale - place;
  wire [4:0] shift = distance > 9'd23 ? 5'd24 : distance[4:0];
  wire [47:0] shifted = {mantissa, 24'd0} >> shift;
  wire [25:0] aligned = {2'b00, shifted[47:24]};
  wire round_down = sign & (|shifted[23:0]);

  assign index = (sign ? 26'd0 - aligned : aligned) - {25'd0, round_down};
endmodule
