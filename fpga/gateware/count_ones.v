// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The number of bits that are set. Combinational.
module count_ones #(
    parameter WIDTH = 3,
    parameter BITS  = 3
) (
    input  wire [WIDTH-1:0] value,
    output reg  [ BITS-1:0] ones
);
  integer i;
  always @(*) begin
    ones = {BITS{1'b0}};
    for (i = 0; i < WIDTH; i = i + 1) ones = ones + {{BITS - 1{1'b0}}, value[i]};
  end
endmodule
