// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Bytes from a serial line: 8 data bits, least significant first, no parity, one stop bit. A bit is sampled in its middle; a byte
// whose stop bit is wrong is dropped. Whoever takes the bytes must be faster than the line: there is room for one.
module uart_rx #(
    parameter CLOCKS_PER_BIT = 16  // at least 4
) (
    input  wire       clk,
    input  wire       reset,
    input  wire       line,
    output reg        valid,
    input  wire       ready,
    output reg  [7:0] data
);
  localparam [15:0] BIT = CLOCKS_PER_BIT - 1;
  localparam [15:0] HALF = CLOCKS_PER_BIT / 2 - 1;
  reg [ 1:0] settled;  // two registers against metastability
  reg [ 7:0] shift;
  reg [ 3:0] bits;  // still to come, with start and stop; 0: the line is idle
  reg [15:0] left;  // clocks to the next sample
  always @(posedge clk) begin
    settled <= {settled[0], line};
    if (valid & ready) valid <= 1'b0;
    left <= left - 16'd1;
    if (bits == 4'd0) begin
      left <= HALF;
      if (!settled[1]) bits <= 4'd10;
    end else if (left == 16'd0) begin
      left <= BIT;
      bits <= bits - 4'd1;
      if (bits == 4'd10) begin
        if (settled[1]) bits <= 4'd0;  // no start bit after all
      end else if (bits != 4'd1) shift <= {settled[1], shift[7:1]};
      else if (settled[1]) begin
        valid <= 1'b1;
        data  <= shift;
      end
    end
    if (reset) begin
      settled <= 2'b11;
      bits    <= 4'd0;
      valid   <= 1'b0;
    end
  end
endmodule
