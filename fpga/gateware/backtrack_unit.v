// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Repairs pairs in memory whose context turned out to be wrong, depth first, child 0 before child 1: reads a line,
// re-encodes one pair of it, writes that pair back; then reports how many. One access at a time: the read leaves in the
// clock the job is taken, the write in the clock its line comes, the next read in the clock after that. Costs two
// reencode_child, a job of 248 bits, a count, and block RAM for 32 waiting second children of 237 bits. Twin of
// rtl_model/compress/backtrack_unit.h; paper algorithm 1, function Backtrack.
`include "cbvh_constants.vh"
module backtrack_unit #(
    parameter N = 6
) (
    input  wire                                  clk,
    input  wire                                  reset,
    input  wire                                  jobs_valid,
    output wire                                  jobs_ready,
    input  wire [     `CBVH_REPAIR_JOB_WIDTH-1:0] jobs_data,
    output wire                                  requests_valid,
    input  wire                                  requests_ready,
    output wire [ `CBVH_MEMORY_REQUEST_WIDTH-1:0] requests_data,
    input  wire                                  lines_valid,
    output wire                                  lines_ready,
    input  wire [    `CBVH_MEMORY_LINE_WIDTH-1:0] lines_data,
    output wire                                  done_valid,
    input  wire                                  done_ready,
    output wire [                          31:0] done_data
);
  localparam [1:0] IDLE = 2'd0;
  localparam [1:0] READ = 2'd1;
  localparam [1:0] WRITE = 2'd2;
  localparam [1:0] REPORT = 2'd3;
  localparam JOB_WIDTH = `CBVH_REPAIR_JOB_WIDTH;
  localparam PLACE_WIDTH = JOB_WIDTH - `CBVH_SCENE_REGISTERS_WIDTH;  // of a child: its pointer and its contexts
  localparam PAIR_WIDTH = `CBVH_NODE_PAIR_WIDTH;

  reg [1:0] state;
  reg [JOB_WIDTH-1:0] current;
  reg [31:0] repairs;
  reg [5:0] depth;  // second children that wait; one a level at most

  wire [`CBVH_POINTER_BITS-1:0] pointer =
      state == IDLE ? jobs_data[`CBVH_REPAIR_JOB_POINTER] : current[`CBVH_REPAIR_JOB_POINTER];
  wire [3:0] mask = 4'd1 << pointer[1:0];
  wire [`CBVH_SCENE_REGISTERS_WIDTH-1:0] registers = current[`CBVH_REPAIR_JOB_REGISTERS];

  // What a line brings. The pair in question is the one of the current job.
  wire [PAIR_WIDTH-1:0] stored = lines_data[PAIR_WIDTH*pointer[1:0]+:PAIR_WIDTH];
  wire [`CBVH_NODE_CODES_WIDTH-1:0] fixed_0, fixed_1;
  wire [`CBVH_CONTEXT_WIDTH-1:0] before_0, before_1, after_0, after_1;
  wire repair_0, repair_1;
  reencode_child #(
      .N(N)
  ) child_0 (
      .codes(stored[`CBVH_NODE_PAIR_CHILD_0]),
      .old_context(current[`CBVH_REPAIR_JOB_BEFORE]),
      .new_context(current[`CBVH_REPAIR_JOB_AFTER]),
      .registers(registers),
      .fixed(fixed_0),
      .child_before(before_0),
      .child_after(after_0),
      .repair(repair_0)
  );
  reencode_child #(
      .N(N)
  ) child_1 (
      .codes(stored[`CBVH_NODE_PAIR_CHILD_1]),
      .old_context(current[`CBVH_REPAIR_JOB_BEFORE]),
      .new_context(current[`CBVH_REPAIR_JOB_AFTER]),
      .registers(registers),
      .fixed(fixed_1),
      .child_before(before_1),
      .child_after(after_1),
      .repair(repair_1)
  );
  wire [PLACE_WIDTH-1:0] place_0 = {after_0, before_0, fixed_0[`CBVH_NODE_CODES_POINTER]};
  wire [PLACE_WIDTH-1:0] place_1 = {after_1, before_1, fixed_1[`CBVH_NODE_CODES_POINTER]};
  wire [PLACE_WIDTH-1:0] waiting, unused_second;
  wire [PLACE_WIDTH-1:0] next = repair_0 ? place_0 : repair_1 ? place_1 : waiting;

  wire reads = (state == IDLE & jobs_valid) | state == READ;
  wire writes = state == WRITE & lines_valid;
  wire repaired = writes & requests_ready;
  wire waits = repaired & repair_0 & repair_1;
  wire resumes = repaired & ~repair_0 & ~repair_1 & (|depth);
  wire [5:0] depth_next = reset ? 6'd0 : waits ? depth + 6'd1 : resumes ? depth - 6'd1 : depth;
  stack_memory #(
      .WIDTH(PLACE_WIDTH)
  ) second_children (
      .clk(clk),
      .depth_next(depth_next),
      .push(waits),
      .place(depth[4:0]),
      .entry(place_1),
      .top_entry(waiting),
      .second_entry(unused_second)
  );
  assign jobs_ready = state == IDLE;
  assign lines_ready = state == WRITE & requests_ready;
  assign requests_valid = reads | writes;
  assign requests_data[`CBVH_MEMORY_REQUEST_WRITE] = writes;
  assign requests_data[`CBVH_MEMORY_REQUEST_LINE] = pointer[`CBVH_POINTER_BITS-1:2];
  assign requests_data[`CBVH_MEMORY_REQUEST_MASK] = mask;
  assign requests_data[`CBVH_MEMORY_REQUEST_PAIRS] = {
    {fixed_1, fixed_0} & {PAIR_WIDTH{writes & mask[3]}},
    {fixed_1, fixed_0} & {PAIR_WIDTH{writes & mask[2]}},
    {fixed_1, fixed_0} & {PAIR_WIDTH{writes & mask[1]}},
    {fixed_1, fixed_0} & {PAIR_WIDTH{writes & mask[0]}}
  };
  assign done_valid = state == REPORT;
  assign done_data = repairs;

  always @(posedge clk) begin
    depth <= depth_next;
    if (jobs_valid & jobs_ready) current <= jobs_data;
    else if (repaired) current[PLACE_WIDTH-1:0] <= next;
    if (jobs_valid & jobs_ready) repairs <= 32'd0;
    else if (repaired) repairs <= repairs + 32'd1;
    if (reset) state <= IDLE;
    else begin
      case (state)
        IDLE: if (jobs_valid) state <= requests_ready ? WRITE : READ;
        READ: if (requests_ready) state <= WRITE;
        WRITE: if (repaired) state <= repair_0 | repair_1 | (|depth) ? READ : REPORT;
        REPORT: if (done_ready) state <= IDLE;
      endcase
    end
  end
endmodule
