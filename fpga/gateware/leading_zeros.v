// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Zeros above the highest set bit; WIDTH for zero. Combinational.
module leading_zeros #(
    parameter WIDTH = 25,
    parameter BITS  = 5
) (
    input  wire [WIDTH-1:0] value,
    output reg  [ BITS-1:0] zeros
);
  integer i;
  reg [BITS-1:0] position;
  always @(*) begin
    zeros    = WIDTH[BITS-1:0];
    position = WIDTH[BITS-1:0];
    for (i = 0; i < WIDTH; i = i + 1) begin
      position = position - 1'b1;
      if (value[i]) zeros = position;
    end
  end
endmodule
