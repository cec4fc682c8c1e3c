// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The treelet that an arriving pair roots: itself on top of the treelets of its children, as floats. Combinational
// between the registers of a stack, which keeps the upper D - 1 levels of every open subtree. Says which pairs of the
// treelet become final: a bit each, first those of level D from left to right, then, if the pair is its tree's root,
// those above in depth-first pre-order. A tree with too many open subtrees, or too few, is refused: of that only its
// root is told. Costs 32 * (2^(D-1) - 1) pairs of 467 bits, read twice and written once a clock. Part of the twin of
// rtl_model/compress/treelet_collector.h: assemble, push_entry and pre_order.
`include "cbvh_constants.vh"
module treelet_assembler #(
    parameter D = 2
) (
    input  wire                                                        clk,
    input  wire                                                        reset,
    input  wire                                                        take,
    input  wire                                                        root,
    input  wire [                          `CBVH_FLOAT_PAIR_WIDTH-1:0] pair,
    output wire [                              `CBVH_POINTER_BITS-1:0] index,
    output wire [((1<<D)-1)*(`CBVH_FLOAT_PAIR_WIDTH+`CBVH_POINTER_BITS)-1:0] nodes,
    output reg  [                                          (1<<D)-2:0] exists,
    output wire [                                          (1<<D)-2:0] finals,
    output wire [                               `CBVH_STATUS_BITS-1:0] status
);
  localparam ROW = 1 << (D - 1);
  localparam NODE_WIDTH = `CBVH_FLOAT_PAIR_WIDTH + `CBVH_POINTER_BITS;
  localparam LEAF = `CBVH_FLOAT_PAIR_WIDTH - 2 * `CBVH_POINTER_BITS - 2;

  reg [`CBVH_POINTER_BITS-1:0] next_index;
  reg [5:0] depth;
  reg [`CBVH_STATUS_BITS-1:0] refused;  // the tree, by an earlier pair

  wire [1:0] inner = ~pair[`CBVH_FLOAT_PAIR_LEAF];
  wire [1:0] pops = {&inner, ^inner};
  wire underflow = {4'd0, pops} > depth;
  wire [5:0] kept = depth - {4'd0, pops};
  wire [5:0] depth_next = reset ? 6'd0 : ~take ? depth : root ? 6'd0 : kept + 6'd1;
  wire overflow = kept == 6'd`CBVH_CONTEXT_STACK_DEPTH;
  assign index = next_index;
  assign status = refused != `CBVH_STATUS_OK ? refused :
                  underflow ? `CBVH_STATUS_UNDERFLOW :
                  overflow ? `CBVH_STATUS_OVERFLOW : `CBVH_STATUS_OK;
  wire accepted = status == `CBVH_STATUS_OK;

  // Position p of the treelet is at p - 1.
  assign nodes[NODE_WIDTH-1:0] = {next_index, pair};
  integer i;
  always @(*) begin
    exists = {2 * ROW - 1{1'b0}};
    exists[0] = 1'b1;
    for (i = 1; i < 2 * ROW - 1; i = i + 1) exists[i] = exists[(i-1)/2] & ~nodes[(i-1)/2*NODE_WIDTH+LEAF+(i+1)%2];
  end
  genvar level, place;
  generate
    if (D > 1) begin : below
      localparam ENTRY_WIDTH = (ROW - 1) * NODE_WIDTH;
      wire [ENTRY_WIDTH-1:0] right, second_entry;
      wire [ENTRY_WIDTH-1:0] left = &inner ? second_entry : right;
      stack_memory #(
          .WIDTH(ENTRY_WIDTH)
      ) entries (
          .clk(clk),
          .depth_next(depth_next),
          .push(take & accepted),
          .place(kept[4:0]),
          .entry(nodes[ENTRY_WIDTH-1:0]),
          .top_entry(right),
          .second_entry(second_entry)
      );
      for (level = 2; level <= D; level = level + 1) begin : levels
        localparam HALF = 1 << (level - 2);
        // Level `level` is level `level - 1` of the left child's treelet, then that of the right child's.
        assign nodes[(2*HALF-1)*NODE_WIDTH+:HALF*NODE_WIDTH] = left[(HALF-1)*NODE_WIDTH+:HALF*NODE_WIDTH];
        assign nodes[(3*HALF-1)*NODE_WIDTH+:HALF*NODE_WIDTH] = right[(HALF-1)*NODE_WIDTH+:HALF*NODE_WIDTH];
      end
    end
  endgenerate

  `include "treelet_pre_order.vh"
  generate
    for (place = 0; place < ROW; place = place + 1) begin : row
      if (place == 0) begin : first
        assign finals[0] = accepted ? exists[ROW-1] : root;
      end else begin : others
        assign finals[place] = accepted & exists[ROW+place-1];
      end
    end
    for (place = 0; place < ROW - 1; place = place + 1) begin : flushed
      localparam POSITION = pre_order(place);
      assign finals[ROW+place] = accepted & root & exists[POSITION-1];
    end
  endgenerate

  always @(posedge clk) begin
    depth <= depth_next;
    if (reset) begin
      next_index <= {`CBVH_POINTER_BITS{1'b0}};
      refused    <= `CBVH_STATUS_OK;
    end else if (take) begin
      next_index <= root ? {`CBVH_POINTER_BITS{1'b0}} : next_index + 1'b1;
      refused    <= root ? `CBVH_STATUS_OK : status;
    end
  end
endmodule
