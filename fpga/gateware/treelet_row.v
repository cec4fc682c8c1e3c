// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What a compressed treelet makes final: a lane each for the pairs of level D, from left to right, then, when the root
// has come, for those above in depth-first pre-order. Looks up the contexts that the pairs below level D were written
// with: a final pair whose child's has changed asks for a repair. Of a refused tree only the first reason is told, when
// its root comes; `unused` is the number of places in the queue that were taken for `finals` and stay empty. Costs a
// stack of 32 * 2^(D-1) contexts of 105 bits, read twice and written once a clock. Part of the twin of
// rtl_model/compress/treelet_collector.h: output_row, push_entry and finish_tree.
`include "cbvh_constants.vh"
module treelet_row #(
    parameter N = 6,
    parameter D = 2
) (
    input  wire                                               clk,
    input  wire                                               reset,
    input  wire                                               valid,
    input  wire                                               root,
    input  wire [                      `CBVH_POINTER_BITS-1:0] index,
    input  wire [                                        1:0] inner,
    input  wire [             `CBVH_SCENE_REGISTERS_WIDTH-1:0] registers,
    input  wire [                                 (1<<D)-2:0] finals,
    input  wire [                       `CBVH_STATUS_BITS-1:0] early_status,
    input  wire [                       `CBVH_STATUS_BITS-1:0] status,
    input  wire [        ((1<<D)-1)*`CBVH_POINTER_BITS-1:0] final_indices,
    input  wire [     ((1<<D)-1)*`CBVH_NODE_PAIR_WIDTH-1:0] final_pairs,
    input  wire [                     `CBVH_CONTEXT_WIDTH-1:0] root_context,
    input  wire [      (1<<(D-1))*`CBVH_CONTEXT_WIDTH-1:0] row_contexts,
    input  wire [           (1<<D)*`CBVH_CONTEXT_WIDTH-1:0] child_contexts,
    output wire [                                 (1<<D)-2:0] lanes_valid,
    output wire [    ((1<<D)-1)*`CBVH_FINAL_PAIR_WIDTH-1:0] lanes_data,
    output wire [                                        D:0] unused
);
  localparam ROW = 1 << (D - 1);
  localparam CONTEXT = `CBVH_CONTEXT_WIDTH;
  localparam FINAL = `CBVH_FINAL_PAIR_WIDTH;
  localparam PAIR = `CBVH_NODE_PAIR_WIDTH;
  localparam INDEX = `CBVH_POINTER_BITS;

  reg [5:0] depth;
  reg [`CBVH_STATUS_BITS-1:0] refused;  // the tree, by pair `refused_index`
  reg [INDEX-1:0] refused_index;

  wire [`CBVH_STATUS_BITS-1:0] tree_status = refused != `CBVH_STATUS_OK ? refused :
                                             early_status != `CBVH_STATUS_OK ? early_status : status;
  wire accepted = tree_status == `CBVH_STATUS_OK;
  wire [INDEX-1:0] bad_index = refused != `CBVH_STATUS_OK ? refused_index : index;
  wire [5:0] kept = depth - {4'd0, &inner, ^inner};
  wire [5:0] depth_next = reset ? 6'd0 : ~valid ? depth : root ? 6'd0 : kept + 6'd1;
  wire [ROW*CONTEXT-1:0] right, second_entry;
  wire [ROW*CONTEXT-1:0] left = &inner ? second_entry : right;
  stack_memory #(
      .WIDTH(ROW * CONTEXT)
  ) entries (
      .clk(clk),
      .depth_next(depth_next),
      .push(valid),
      .place(kept[4:0]),
      .entry(row_contexts),
      .top_entry(right),
      .second_entry(second_entry)
  );
  wire [2*ROW*CONTEXT-1:0] written = {right, left};

  `include "treelet_pre_order.vh"

  genvar lane, child;
  generate
    for (lane = 0; lane < 2 * ROW - 1; lane = lane + 1) begin : lanes
      localparam POSITION = lane < ROW ? ROW + lane : pre_order(lane - ROW);
      wire is_last;
      wire [1:0] repair;
      wire [2*CONTEXT-1:0] before_repair, after_repair;
      if (lane == 2 * ROW - 2) begin : end_of_tree
        assign is_last = root & finals[lane];
      end else begin : end_of_tree
        assign is_last = root & finals[lane] & ~(|finals[2*ROW-2:lane+1]);
      end
      if (lane < ROW) begin : in_row
        for (child = 0; child < 2; child = child + 1) begin : children
          localparam BELOW = 2 * lane + child;
          wire changed;
          wire leaf = final_pairs[(POSITION-1)*PAIR+(PAIR/2)*child+PAIR/2-1-INDEX];
          context_changed change (
              .old_context(written[BELOW*CONTEXT+:CONTEXT]),
              .new_context(child_contexts[BELOW*CONTEXT+:CONTEXT]),
              .relative(registers[`CBVH_SCENE_REGISTERS_RELATIVE]),
              .changed(changed)
          );
          assign repair[child] = ~leaf & changed;
          assign before_repair[child*CONTEXT+:CONTEXT] = written[BELOW*CONTEXT+:CONTEXT] & {CONTEXT{repair[child]}};
          assign after_repair[child*CONTEXT+:CONTEXT] =
              child_contexts[BELOW*CONTEXT+:CONTEXT] & {CONTEXT{repair[child]}};
        end
      end else begin : flushed
        assign repair = 2'b00;
        assign before_repair = {2 * CONTEXT{1'b0}};
        assign after_repair = {2 * CONTEXT{1'b0}};
      end
      wire [FINAL-1:0] final_pair;
      assign final_pair[`CBVH_FINAL_PAIR_INDEX] = final_indices[(POSITION-1)*INDEX+:INDEX];
      assign final_pair[`CBVH_FINAL_PAIR_PAIR] = final_pairs[(POSITION-1)*PAIR+:PAIR];
      assign final_pair[`CBVH_FINAL_PAIR_REPAIR] = repair;
      assign final_pair[`CBVH_FINAL_PAIR_BEFORE] = before_repair;
      assign final_pair[`CBVH_FINAL_PAIR_AFTER] = after_repair;
      assign final_pair[`CBVH_FINAL_PAIR_LAST] = is_last;
      assign final_pair[`CBVH_FINAL_PAIR_ROOT] = root_context & {CONTEXT{is_last}};
      assign final_pair[`CBVH_FINAL_PAIR_STATUS] = `CBVH_STATUS_OK;
      assign final_pair[`CBVH_FINAL_PAIR_REGISTERS] = registers;
      if (lane == 0) begin : or_refusal
        wire [FINAL-1:0] refusal;
        assign refusal[`CBVH_FINAL_PAIR_INDEX] = bad_index;
        assign refusal[`CBVH_FINAL_PAIR_PAIR] = {PAIR{1'b0}};
        assign refusal[`CBVH_FINAL_PAIR_REPAIR] = 2'b00;
        assign refusal[`CBVH_FINAL_PAIR_BEFORE] = {2 * CONTEXT{1'b0}};
        assign refusal[`CBVH_FINAL_PAIR_AFTER] = {2 * CONTEXT{1'b0}};
        assign refusal[`CBVH_FINAL_PAIR_LAST] = 1'b1;
        assign refusal[`CBVH_FINAL_PAIR_ROOT] = {CONTEXT{1'b0}};
        assign refusal[`CBVH_FINAL_PAIR_STATUS] = tree_status;
        assign refusal[`CBVH_FINAL_PAIR_REGISTERS] = registers;
        assign lanes_valid[0] = valid & (accepted ? finals[0] : root);
        assign lanes_data[0+:FINAL] = accepted ? final_pair : refusal;
      end else begin : or_nothing
        assign lanes_valid[lane] = valid & accepted & finals[lane];
        assign lanes_data[lane*FINAL+:FINAL] = final_pair;
      end
    end
  endgenerate

  wire [D:0] places;
  count_ones #(
      .WIDTH(2 * ROW - 1),
      .BITS (D + 1)
  ) taken (
      .value(finals),
      .ones (places)
  );
  assign unused = valid & ~accepted ? places - {{D{1'b0}}, root} : {D + 1{1'b0}};

  always @(posedge clk) begin
    depth <= depth_next;
    if (valid) refused_index <= bad_index;
    if (reset) refused <= `CBVH_STATUS_OK;
    else if (valid) refused <= root ? `CBVH_STATUS_OK : tree_status;
  end
endmodule
