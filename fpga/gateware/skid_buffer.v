// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A two-entry skid buffer between two modules: valid and ready both come from registers, full rate. Twin of
// rtl_model/kernel/channel.h.
module skid_buffer #(
    parameter WIDTH = 1
) (
    input  wire             clk,
    input  wire             reset,
    input  wire             in_valid,
    output wire             in_ready,
    input  wire [WIDTH-1:0] in_data,
    output wire             out_valid,
    input  wire             out_ready,
    output wire [WIDTH-1:0] out_data
);
  reg [WIDTH-1:0] oldest;
  reg [WIDTH-1:0] newer;  // behind it, while full
  reg             occupied;
  reg             full;

  // A register that moves up rather than a choice between two: a look-up table and a flip-flop of one logic cell a bit.
  // Where the taker is always ready, synthesis sees that it is never full and drops the second entry.
  wire stays = occupied & ~out_ready;
  assign in_ready  = ~full;
  assign out_valid = occupied;
  assign out_data  = oldest;

  always @(posedge clk) begin
    if (~stays) oldest <= full ? newer : in_data;
    if (~full) newer <= in_data;
    if (reset) begin
      occupied <= 1'b0;
      full     <= 1'b0;
    end else begin
      occupied <= in_valid | full | stays;
      full     <= stays & (in_valid | full);
    end
  end
endmodule
