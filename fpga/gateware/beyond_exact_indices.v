// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Whether an index lies outside -2^24..2^24, where an edge need not be a float. Combinational. Twin of
// beyond_exact_indices in rtl_model/datapath/decode_box.h.
module beyond_exact_indices #(
    parameter WIDTH = 26
) (
    input  wire [WIDTH-1:0] index,
    output wire             beyond
);
  localparam [WIDTH-1:0] LARGEST = {{WIDTH - 25{1'b0}}, 1'b1, 24'd0};
  wire [WIDTH-1:0] above_lowest = index + LARGEST;  // modulo 2^WIDTH: what is below it comes out above all
  assign beyond = above_lowest > {LARGEST[WIDTH-2:0], 1'b0};
endmodule
