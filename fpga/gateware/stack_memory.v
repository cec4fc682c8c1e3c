// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The entries of a stack of open subtrees, and its two uppermost at any time. Whoever uses it keeps the depth: `depth_next`
// is the one after this clock, and a push writes the entry at `place`, below that. The places that are read lie in
// registers, so that 32 entries of WIDTH bits fit block RAM with a register and a bypass of WIDTH bits a port; they are as
// if read at once. No reset, no word of an empty stack.
`include "cbvh_constants.vh"
module stack_memory #(
    parameter WIDTH = 1
) (
    input  wire             clk,
    input  wire [      5:0] depth_next,
    input  wire             push,
    input  wire [      4:0] place,
    input  wire [WIDTH-1:0] entry,
    output wire [WIDTH-1:0] top_entry,
    output wire [WIDTH-1:0] second_entry
);
  reg [WIDTH-1:0] words[0:`CBVH_CONTEXT_STACK_DEPTH-1];
  reg [4:0] top, second;
  assign top_entry = words[top];
  assign second_entry = words[second];
  wire unused_depth = depth_next[5];
  always @(posedge clk) begin
    if (push) words[place] <= entry;
    top    <= depth_next[4:0] - 5'd1;
    second <= depth_next[4:0] - 5'd2;
  end
endmodule
