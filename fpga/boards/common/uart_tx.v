// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Bytes to a serial line: 8 data bits, least significant first, no parity, one stop bit.
module uart_tx #(
    parameter CLOCKS_PER_BIT = 16
) (
    input  wire       clk,
    input  wire       reset,
    input  wire       valid,
    output wire       ready,
    input  wire [7:0] data,
    output wire       line
);
  localparam [15:0] BIT = CLOCKS_PER_BIT - 1;
  reg [ 9:0] shift;  // what the line shows and will show; ones behind
  reg [ 3:0] bits;  // still on the line
  reg [15:0] left;
  assign ready = bits == 4'd0;
  assign line  = shift[0];
  always @(posedge clk) begin
    left <= left - 16'd1;
    if (ready) begin
      left <= BIT;
      if (valid) begin
        shift <= {1'b1, data, 1'b0};
        bits  <= 4'd10;
      end
    end else if (left == 16'd0) begin
      left  <= BIT;
      shift <= {1'b1, shift[9:1]};
      bits  <= bits - 4'd1;
    end
    if (reset) begin
      shift <= 10'h3FF;
      bits  <= 4'd0;
    end
  end
endmodule
