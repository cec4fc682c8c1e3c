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
  reg [5:0] depth;

  wire [1:0] pops = operations_data[`CBVH_STACK_OPERATION_POPS];
  wire push = operations_data[`CBVH_STACK_OPERATION_PUSH];
  wire underflow = (pops == 2'd3) | ({4'd0, pops} > depth);
  wire [5:0] kept = depth - {4'd0, pops};
  wire overflow = push & ~underflow & (kept == 6'd`CBVH_CONTEXT_STACK_DEPTH);
  wire accepted = ~underflow & ~overflow;
  wire moves = operations_valid & replies_ready;
  wire [5:0] depth_wanted = accepted ? kept + {5'd0, push} : depth;
  wire [5:0] depth_next = reset ? 6'd0 : moves ? depth_wanted : depth;
  wire [`CBVH_CONTEXT_WIDTH-1:0] top_entry, second_entry;
  stack_memory #(
      .WIDTH(`CBVH_CONTEXT_WIDTH)
  ) entries (
      .clk(clk),
      .depth_next(depth_next),
      .push(moves & accepted & push),
      .place(kept[4:0]),
      .entry(operations_data[`CBVH_STACK_OPERATION_CONTEXT]),
      .top_entry(top_entry),
      .second_entry(second_entry)
  );

  assign operations_ready = replies_ready;
  assign replies_valid = operations_valid;
  assign replies_data[`CBVH_STACK_REPLY_POPPED_0] = top_entry & {`CBVH_CONTEXT_WIDTH{accepted & (|pops)}};
  assign replies_data[`CBVH_STACK_REPLY_POPPED_1] = second_entry & {`CBVH_CONTEXT_WIDTH{accepted & pops[1]}};
  assign replies_data[`CBVH_STACK_REPLY_DEPTH] = depth_wanted;
  assign replies_data[`CBVH_STACK_REPLY_STATUS] = underflow ? `CBVH_STATUS_UNDERFLOW :
                                                  overflow ? `CBVH_STATUS_OVERFLOW : `CBVH_STATUS_OK;

  always @(posedge clk) depth <= depth_next;
endmodule
