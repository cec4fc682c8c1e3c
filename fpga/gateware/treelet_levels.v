// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Compresses a treelet a clock, top down: 2^D - 1 node pair compressors, 6 clocks a level. The context is estimated at
// the root only. Everything comes out 6 D - 1 clocks after `nodes`: the compressed pairs by position, the contexts they
// were compressed with and, of level D, those of their children; `status` is that of the first refused pair by
// position. Part of the twin of rtl_model/compress/treelet_collector.h: compress.
`include "cbvh_constants.vh"
module treelet_levels #(
    parameter N = 6,
    parameter D = 2
) (
    input  wire                                                                     clk,
    input  wire                                                                     reset,
    input  wire [((1<<D)-1)*(`CBVH_FLOAT_PAIR_WIDTH+`CBVH_POINTER_BITS)-1:0] nodes,
    input  wire [(1<<D)-2:0] exists,
    input  wire [`CBVH_SCENE_REGISTERS_WIDTH-1:0] registers,
    output wire [((1<<D)-1)*`CBVH_POINTER_BITS-1:0] final_indices,
    output wire [((1<<D)-1)*`CBVH_NODE_PAIR_WIDTH-1:0] final_pairs,
    output wire [`CBVH_CONTEXT_WIDTH-1:0] root_context,
    output wire [(1<<(D-1))*`CBVH_CONTEXT_WIDTH-1:0] row_contexts,
    output wire [(1<<D)*`CBVH_CONTEXT_WIDTH-1:0] child_contexts,
    output wire [`CBVH_STATUS_BITS-1:0] status
);
  localparam NODE_WIDTH = `CBVH_FLOAT_PAIR_WIDTH + `CBVH_POINTER_BITS;
  localparam CONTEXT = `CBVH_CONTEXT_WIDTH;
  localparam STATUS = `CBVH_STATUS_BITS;

  genvar level, place;
  generate
    for (level = 1; level <= D; level = level + 1) begin : levels
      localparam SIZE = 1 << (level - 1);
      wire [`CBVH_SCENE_REGISTERS_WIDTH-1:0] level_registers;
      wire [SIZE-1:0] level_exists;  // when its results are there
      wire [SIZE*CONTEXT-1:0] given, contexts_or_unused;
      wire [2*SIZE*CONTEXT-1:0] below;
      wire [SIZE*STATUS-1:0] reasons;
      wire [STATUS-1:0] above;  // of the levels above this one
      delay_line #(
          .WIDTH (SIZE),
          .LENGTH(6 * level - 1)
      ) existence (
          .clk(clk),
          .reset(reset),
          .in_data(exists[SIZE-1+:SIZE]),
          .out_data(level_exists)
      );
      if (level == 1) begin : first
        assign level_registers = registers;
        assign given = {CONTEXT{1'b0}};
        assign above = `CBVH_STATUS_OK;
      end else begin : next
        delay_line #(
            .WIDTH (`CBVH_SCENE_REGISTERS_WIDTH),
            .LENGTH(6)
        ) scene (
            .clk(clk),
            .reset(reset),
            .in_data(levels[level-1].level_registers),
            .out_data(level_registers)
        );
        delay_line #(
            .WIDTH (SIZE * CONTEXT),
            .LENGTH(1)
        ) handover (
            .clk(clk),
            .reset(reset),
            .in_data(levels[level-1].below),
            .out_data(given)
        );
        delay_line #(
            .WIDTH (STATUS),
            .LENGTH(6)
        ) reason_above (
            .clk(clk),
            .reset(reset),
            .in_data(levels[level-1].reason),
            .out_data(above)
        );
      end
      for (place = 0; place < SIZE; place = place + 1) begin : places
        localparam AT = SIZE + place - 1;
        treelet_node #(
            .N(N),
            .D(D),
            .LEVEL(level)
        ) member (
            .clk(clk),
            .reset(reset),
            .node(nodes[AT*NODE_WIDTH+:NODE_WIDTH]),
            .registers(level_registers),
            .given_context(given[place*CONTEXT+:CONTEXT]),
            .own_context(contexts_or_unused[place*CONTEXT+:CONTEXT]),
            .child_contexts(below[2*place*CONTEXT+:2*CONTEXT]),
            .status(reasons[place*STATUS+:STATUS]),
            .final_index(final_indices[AT*`CBVH_POINTER_BITS+:`CBVH_POINTER_BITS]),
            .final_pair(final_pairs[AT*`CBVH_NODE_PAIR_WIDTH+:`CBVH_NODE_PAIR_WIDTH])
        );
      end
      reg [STATUS-1:0] reason;
      integer i;
      always @(*) begin
        reason = above;
        for (i = 0; i < SIZE; i = i + 1) begin
          if (reason == `CBVH_STATUS_OK) reason = reasons[i*STATUS+:STATUS] & {STATUS{level_exists[i]}};
        end
      end
    end
  endgenerate
  delay_line #(
      .WIDTH (CONTEXT),
      .LENGTH(6 * (D - 1))
  ) roots (
      .clk(clk),
      .reset(reset),
      .in_data(levels[1].contexts_or_unused),
      .out_data(root_context)
  );
  assign row_contexts = levels[D].contexts_or_unused;
  assign child_contexts = levels[D].below;
  assign status = levels[D].reason;
endmodule
