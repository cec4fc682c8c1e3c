// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A queue of bytes in block RAM. It is never in a hurry: after a byte has been taken the next one comes two clocks later.
module byte_fifo #(
    parameter ADDRESS_BITS = 9
) (
    input  wire       clk,
    input  wire       reset,
    input  wire       in_valid,
    output wire       in_ready,
    input  wire [7:0] in_data,
    output reg        out_valid,
    input  wire       out_ready,
    output wire [7:0] out_data
);
  reg [ADDRESS_BITS:0] head, tail;
  reg fetched;
  wire [ADDRESS_BITS:0] count = tail - head;
  assign in_ready = !count[ADDRESS_BITS];
  byte_memory #(
      .ADDRESS_BITS(ADDRESS_BITS)
  ) memory (
      .clk(clk),
      .write(in_valid & in_ready),
      .write_address(tail[ADDRESS_BITS-1:0]),
      .write_data(in_data),
      .read_address(head[ADDRESS_BITS-1:0]),
      .read_data(out_data)
  );
  always @(posedge clk) begin
    if (in_valid & in_ready) tail <= tail + 1'b1;
    fetched   <= count != 0 && !(out_valid & out_ready);
    out_valid <= fetched && !(out_valid & out_ready);
    if (out_valid & out_ready) head <= head + 1'b1;
    if (reset) begin
      head      <= 0;
      tail      <= 0;
      fetched   <= 1'b0;
      out_valid <= 1'b0;
    end
  end
endmodule
