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
  reg [WIDTH-1:0] entry_0;
  reg [WIDTH-1:0] entry_1;
  reg             head;
  reg             occupied;
  reg             full;

  wire push = in_valid & in_ready;
  wire pop = out_valid & out_ready;
  wire tail = head ^ occupied;

  assign in_ready  = ~full;
  assign out_valid = occupied;
  assign out_data  = head ? entry_1 : entry_0;

  always @(posedge clk) begin
    if (push & ~tail) entry_0 <= in_data;
    if (push & tail) entry_1 <= in_data;
    if (reset) begin
      head     <= 1'b0;
      occupied <= 1'b0;
      full     <= 1'b0;
    end else begin
      head     <= head ^ pop;
      occupied <= push | (occupied & (full | ~pop));
      full     <= full ? ~pop : (occupied & push & ~pop);
    end
  end
endmodule
