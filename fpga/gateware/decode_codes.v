// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The cells of a stored pair of codes along one axis, on the grid of the node they are in. Combinational. Twin of
// decode_codes in rtl_model/datapath/codes.h; rule 5.
`include "cbvh_constants.vh"
module decode_codes #(
    parameter N = 6
) (
    input  wire        [              N-1:0] lo,
    input  wire        [              N-1:0] hi,
    input  wire signed [`CBVH_INDEX_BITS-1:0] parent_lower,
    input  wire                              relative,
    output wire signed [`CBVH_INDEX_BITS-1:0] lower,
    output wire signed [`CBVH_INDEX_BITS-1:0] upper  // exclusive
);
  wire [N-1:0] base = parent_lower[N-1:0] & {N{~relative}};
  wire [N-1:0] r = lo - base;
  wire [N-1:0] s = hi - base;
  wire full = ~(|s);  // a span of 0 means 2^N
  assign lower = parent_lower + {{`CBVH_INDEX_BITS - N{1'b0}}, r};
  assign upper = parent_lower + {{`CBVH_INDEX_BITS - N - 1{1'b0}}, full, s};
endmodule
