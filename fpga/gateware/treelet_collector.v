// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Collects arriving float pairs into treelets of up to D levels and compresses each treelet anew, top down, with 2^D -
// 1 node pair compressors: the context is estimated at its root only. Pairs at level D become final. Takes a pair a
// clock while its output queue has room for a row; a final pair leaves 6 D + 1 clocks after the arrival that made it
// so, or later, one a clock. The way from arrival to queue never holds: an arrival takes the places that it will need
// along, and of a refused tree they come free when the reason is known. Costs: see the parts; 2^D - 1 node pair
// compressors and a queue of max(64, 2^(D+3)) final pairs are most of it. D is 1..8. Twin of
// rtl_model/compress/treelet_collector.h; paper section 4.3, figure 8.
`include "cbvh_constants.vh"
module treelet_collector #(
    parameter N = 6,
    parameter D = 2
) (
    input  wire                              clk,
    input  wire                              reset,
    input  wire                              jobs_valid,
    output wire                              jobs_ready,
    input  wire [`CBVH_STREAM_JOB_WIDTH-1:0] jobs_data,
    output wire                              finals_valid,
    input  wire                              finals_ready,
    output wire [`CBVH_FINAL_PAIR_WIDTH-1:0] finals_data
);
  localparam ROW = 1 << (D - 1);
  localparam POSITIONS = 2 * ROW - 1;
  localparam PLACES_LOG2 = D < 3 ? 6 : D + 3;
  localparam CLOCKS = 6 * D - 1;  // from arrival to queue
  localparam NODE_WIDTH = `CBVH_FLOAT_PAIR_WIDTH + `CBVH_POINTER_BITS;

  wire take = jobs_valid & jobs_ready;
  wire arriving_root = jobs_data[`CBVH_STREAM_JOB_ROOT];
  wire [`CBVH_POINTER_BITS-1:0] arriving_index;
  wire [POSITIONS*NODE_WIDTH-1:0] nodes;
  wire [POSITIONS-1:0] exists, arriving_finals;
  wire [`CBVH_STATUS_BITS-1:0] arriving_status;
  treelet_assembler #(
      .D(D)
  ) assembler (
      .clk(clk),
      .reset(reset),
      .take(take),
      .root(arriving_root),
      .pair(jobs_data[`CBVH_STREAM_JOB_PAIR]),
      .index(arriving_index),
      .nodes(nodes),
      .exists(exists),
      .finals(arriving_finals),
      .status(arriving_status)
  );

  wire [POSITIONS*`CBVH_POINTER_BITS-1:0] final_indices;
  wire [POSITIONS*`CBVH_NODE_PAIR_WIDTH-1:0] final_pairs;
  wire [`CBVH_CONTEXT_WIDTH-1:0] root_context;
  wire [ROW*`CBVH_CONTEXT_WIDTH-1:0] row_contexts;
  wire [2*ROW*`CBVH_CONTEXT_WIDTH-1:0] child_contexts;
  wire [`CBVH_STATUS_BITS-1:0] status;
  treelet_levels #(
      .N(N),
      .D(D)
  ) compression (
      .clk(clk),
      .reset(reset),
      .nodes(nodes),
      .exists(exists),
      .registers(jobs_data[`CBVH_STREAM_JOB_REGISTERS]),
      .final_indices(final_indices),
      .final_pairs(final_pairs),
      .root_context(root_context),
      .row_contexts(row_contexts),
      .child_contexts(child_contexts),
      .status(status)
  );

  // What goes along.
  wire root;
  wire [`CBVH_POINTER_BITS-1:0] index;
  wire [1:0] leaf;
  wire [`CBVH_SCENE_REGISTERS_WIDTH-1:0] registers;
  wire [POSITIONS-1:0] finals;
  wire [`CBVH_STATUS_BITS-1:0] early_status;
  delay_line #(
      .WIDTH (1 + `CBVH_POINTER_BITS + 2 + `CBVH_SCENE_REGISTERS_WIDTH + POSITIONS + `CBVH_STATUS_BITS),
      .LENGTH(CLOCKS)
  ) arrivals (
      .clk(clk),
      .reset(reset),
      .in_data({
        arriving_root,
        arriving_index,
        jobs_data[`CBVH_STREAM_JOB_PAIR_LEAF],
        jobs_data[`CBVH_STREAM_JOB_REGISTERS],
        arriving_finals,
        arriving_status
      }),
      .out_data({root, index, leaf, registers, finals, early_status})
  );
  reg [CLOCKS-1:0] valid;
  always @(posedge clk) valid <= reset ? {CLOCKS{1'b0}} : {valid[CLOCKS-2:0], take};

  wire [POSITIONS-1:0] lanes_valid;
  wire [POSITIONS*`CBVH_FINAL_PAIR_WIDTH-1:0] lanes_data;
  wire [D:0] unused_places;
  treelet_row #(
      .N(N),
      .D(D)
  ) row (
      .clk(clk),
      .reset(reset),
      .valid(valid[CLOCKS-1]),
      .root(root),
      .index(index),
      .inner(~leaf),
      .registers(registers),
      .finals(finals),
      .early_status(early_status),
      .status(status),
      .final_indices(final_indices),
      .final_pairs(final_pairs),
      .root_context(root_context),
      .row_contexts(row_contexts),
      .child_contexts(child_contexts),
      .lanes_valid(lanes_valid),
      .lanes_data(lanes_data),
      .unused(unused_places)
  );
  final_queue #(
      .WIDTH(`CBVH_FINAL_PAIR_WIDTH),
      .D(D),
      .PLACES_LOG2(PLACES_LOG2)
  ) queue (
      .clk(clk),
      .reset(reset),
      .in_valid(lanes_valid),
      .in_data(lanes_data),
      .out_valid(finals_valid),
      .out_ready(finals_ready),
      .out_data(finals_data)
  );

  // Places of the queue that are taken or will be.
  wire [D:0] places;
  count_ones #(
      .WIDTH(POSITIONS),
      .BITS (D + 1)
  ) count (
      .value(arriving_finals),
      .ones (places)
  );
  reg [PLACES_LOG2:0] taken;
  wire [PLACES_LOG2:0] taken_now = taken - {{PLACES_LOG2{1'b0}}, finals_valid & finals_ready};
  localparam [PLACES_LOG2:0] MOST_OF_ROOT = (1 << PLACES_LOG2) - POSITIONS;
  localparam [PLACES_LOG2:0] MOST_OF_OTHERS = (1 << PLACES_LOG2) - ROW;
  assign jobs_ready = taken_now <= (arriving_root ? MOST_OF_ROOT : MOST_OF_OTHERS);
  always @(posedge clk) begin
    if (reset) taken <= {PLACES_LOG2 + 1{1'b0}};
    else begin
      taken <= taken_now + ({{PLACES_LOG2 - D{1'b0}}, places} & {PLACES_LOG2 + 1{take}}) -
               {{PLACES_LOG2 - D{1'b0}}, unused_places};
    end
  end
endmodule
