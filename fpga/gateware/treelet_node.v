// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// One pair of a treelet on its way through a collector of D levels: waits 6 clocks a level for the context that its
// parent gives it, is compressed, and waits for those below it. `own_context`, `child_contexts` and `status` come 6 LEVEL -
// 1 clocks after `node`, `final_index` and `final_pair` 6 D - 1. Costs a node_pair_compressor, and 6 (LEVEL - 1)
// clocks' float pairs of 440 bits, 6 (D - LEVEL) clocks' compressed pairs and 6 D - 1 clocks' indices in memories.
`include "cbvh_constants.vh"
module treelet_node #(
    parameter N = 6,
    parameter D = 2,
    parameter LEVEL = 1
) (
    input  wire                                              clk,
    input  wire                                              reset,
    input  wire [`CBVH_FLOAT_PAIR_WIDTH+`CBVH_POINTER_BITS-1:0] node,
    input  wire [           `CBVH_SCENE_REGISTERS_WIDTH-1:0] registers,
    input  wire [                   `CBVH_CONTEXT_WIDTH-1:0] given_context,
    output wire [                   `CBVH_CONTEXT_WIDTH-1:0] own_context,
    output wire [                 2*`CBVH_CONTEXT_WIDTH-1:0] child_contexts,
    output wire [                     `CBVH_STATUS_BITS-1:0] status,
    output wire [                    `CBVH_POINTER_BITS-1:0] final_index,
    output wire [                 `CBVH_NODE_PAIR_WIDTH-1:0] final_pair
);
  wire [`CBVH_FLOAT_PAIR_WIDTH-1:0] pair;
  delay_line #(
      .WIDTH (`CBVH_FLOAT_PAIR_WIDTH),
      .LENGTH(6 * (LEVEL - 1))
  ) float_pairs (
      .clk(clk),
      .reset(reset),
      .in_data(node[`CBVH_FLOAT_PAIR_WIDTH-1:0]),
      .out_data(pair)
  );
  delay_line #(
      .WIDTH (`CBVH_POINTER_BITS),
      .LENGTH(6 * D - 1)
  ) indices (
      .clk(clk),
      .reset(reset),
      .in_data(node[`CBVH_FLOAT_PAIR_WIDTH+:`CBVH_POINTER_BITS]),
      .out_data(final_index)
  );

  wire [`CBVH_PAIR_JOB_WIDTH-1:0] job;
  assign job[`CBVH_PAIR_JOB_PAIR] = pair;
  assign job[`CBVH_PAIR_JOB_GIVEN_CONTEXT] = LEVEL > 1;
  assign job[`CBVH_PAIR_JOB_CONTEXT] = given_context;
  assign job[`CBVH_PAIR_JOB_REGISTERS] = registers;
  wire [`CBVH_PAIR_RESULT_WIDTH-1:0] result;
  wire unused_ready, unused_valid;  // it never holds
  node_pair_compressor #(
      .N(N)
  ) compressor (
      .clk(clk),
      .reset(reset),
      .jobs_valid(1'b1),
      .jobs_ready(unused_ready),
      .jobs_data(job),
      .results_valid(unused_valid),
      .results_ready(1'b1),
      .results_data(result)
  );
  assign own_context = result[`CBVH_PAIR_RESULT_CONTEXT];
  assign child_contexts = result[`CBVH_PAIR_RESULT_CHILD_CONTEXT];
  assign status = result[`CBVH_PAIR_RESULT_STATUS];
  delay_line #(
      .WIDTH (`CBVH_NODE_PAIR_WIDTH),
      .LENGTH(6 * (D - LEVEL))
  ) compressed_pairs (
      .clk(clk),
      .reset(reset),
      .in_data(result[`CBVH_PAIR_RESULT_PAIR]),
      .out_data(final_pair)
  );
endmodule
