// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Traversal contexts of open subtrees. An operation a clock: takes up to two, then adds one. Latency 1: the register is
// the channel behind `replies`. Twin of rtl_model/compress/context_stack.h; paper algorithm 1, contextStack.
`include "cbvh_constants.vh"
module context_stack (
    input  wire                                 clk,
    input  wire                                 reset,
    input  wire                                 operations_valid,
    output wire                                 operations_ready,
    input  wire [`CBVH_STACK_OPERATION_WIDTH-1:0] operations_data,
    output wire                                 replies_valid,
    input  wire                                 replies_ready,
    output wire [    `CBVH_STACK_REPLY_WIDTH-1:0] replies_data
);
  reg [`CBVH_CONTEXT_WIDTH-1:0] entries[0:`CBVH_CONTEXT_STACK_DEPTH-1];
  reg [5:0] depth;

  wire [1:0] pops = operations_data[`CBVH_STACK_OPERATION_POPS];
  wire push = operations_data[`CBVH_STACK_OPERATION_PUSH];
  wire underflow = (pops == 2'd3) | ({4'd0, pops} > depth);
  wire [5:0] kept = depth - {4'd0, pops};
  wire overflow = push & ~underflow & (kept == 6'd`CBVH_CONTEXT_STACK_DEPTH);
  wire accepted = ~underflow & ~overflow;
  wire [5:0] depth_next = accepted ? kept + {5'd0, push} : depth;
  wire [4:0] top = depth[4:0] - 5'd1;
  wire [4:0] second = depth[4:0] - 5'd2;
  wire [`CBVH_CONTEXT_WIDTH-1:0] top_entry = entries[top];
  wire [`CBVH_CONTEXT_WIDTH-1:0] second_entry = entries[second];
  wire moves = operations_valid & replies_ready;

  assign operations_ready = replies_ready;
  assign replies_valid = operations_valid;
  assign replies_data[`CBVH_STACK_REPLY_POPPED_0] = top_entry & {`CBVH_CONTEXT_WIDTH{accepted & (|pops)}};
  assign replies_data[`CBVH_STACK_REPLY_POPPED_1] = second_entry & {`CBVH_CONTEXT_WIDTH{accepted & pops[1]}};
  assign replies_data[`CBVH_STACK_REPLY_DEPTH] = depth_next;
  assign replies_data[`CBVH_STACK_REPLY_STATUS] = underflow ? `CBVH_STATUS_UNDERFLOW :
                                                  overflow ? `CBVH_STATUS_OVERFLOW : `CBVH_STATUS_OK;

  always @(posedge clk) begin
    if (moves & accepted & push) entries[kept[4:0]] <= operations_data[`CBVH_STACK_OPERATION_CONTEXT];
    if (reset) depth <= 6'd0;
    else if (moves) depth <= depth_next;
  end
endmodule
