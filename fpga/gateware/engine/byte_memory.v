// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A block RAM of bytes: one port writes, the other reads what its address chose a clock ago.
module byte_memory #(
    parameter ADDRESS_BITS = 12,
    parameter WIDTH = 8
) (
    input  wire                    clk,
    input  wire                    write,
    input  wire [ADDRESS_BITS-1:0] write_address,
    input  wire [       WIDTH-1:0] write_data,
    input  wire [ADDRESS_BITS-1:0] read_address,
    output reg  [       WIDTH-1:0] read_data
);
  reg [WIDTH-1:0] bytes[0:(1<<ADDRESS_BITS)-1];
  always @(posedge clk) begin
    if (write) bytes[write_address] <= write_data;
    read_data <= bytes[read_address];
  end
endmodule
