// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The memory side of the stream compressor: combines final pairs into 64-byte lines, hands their repairs to the
// backtrack unit in order, and lets that unit's accesses through to the one memory port. A line that is still being
// combined is written before a repair may read it. A final pair is taken a clock, unless the line before it has to wait
// for the port or fewer than two repairs fit the queue. The report leaves in the clock in which the last line does, with
// no repair open. Costs a line, a report and a queue of 16 repairs of 248 bits. Twin of
// rtl_model/compress/line_combiner.h; paper section 5.3.
`include "cbvh_constants.vh"
module line_combiner #(
    parameter N = 6
) (
    input  wire                                 clk,
    input  wire                                 reset,
    input  wire                                 finals_valid,
    output wire                                 finals_ready,
    input  wire [    `CBVH_FINAL_PAIR_WIDTH-1:0] finals_data,
    output wire                                 repair_jobs_valid,
    input  wire                                 repair_jobs_ready,
    output wire [    `CBVH_REPAIR_JOB_WIDTH-1:0] repair_jobs_data,
    input  wire                                 repairs_done_valid,
    output wire                                 repairs_done_ready,
    input  wire [                         31:0] repairs_done_data,
    input  wire                                 repair_requests_valid,
    output wire                                 repair_requests_ready,
    input  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] repair_requests_data,
    output wire                                 memory_valid,
    input  wire                                 memory_ready,
    output wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] memory_data,
    output wire                                 reports_valid,
    input  wire                                 reports_ready,
    output wire [ `CBVH_STREAM_REPORT_WIDTH-1:0] reports_data
);
  localparam PAIR = `CBVH_NODE_PAIR_WIDTH;
  localparam JOB = `CBVH_REPAIR_JOB_WIDTH;

  // The line being combined, once `holds` is set; else all of it is zero.
  reg holds;
  reg [`CBVH_LINE_BITS-1:0] line;
  reg [3:0] mask;
  reg [4*PAIR-1:0] pairs;
  // The report to be, and whether only it is left to be done.
  reg finishing;
  reg [5:0] unfinished;
  reg [31:0] repairs;
  reg [`CBVH_POINTER_BITS-1:0] last_index;
  reg [`CBVH_CONTEXT_WIDTH-1:0] root;
  reg [`CBVH_STATUS_BITS-1:0] status;
  reg [`CBVH_POINTER_BITS-1:0] highest;

  // Repairs that are done.
  assign repairs_done_ready = 1'b1;
  wire [5:0] unfinished_now = unfinished - {5'd0, repairs_done_valid};
  wire [31:0] repairs_now = repairs + (repairs_done_data & {32{repairs_done_valid}});

  // Accesses of the backtrack unit come first.
  wire wanted = holds & line == repair_requests_data[`CBVH_MEMORY_REQUEST_LINE];
  assign repair_requests_ready = memory_ready & ~wanted;
  wire flushes_for_read = repair_requests_valid & memory_ready & wanted;
  wire port_free = memory_ready & ~repair_requests_valid;

  // The end of a tree.
  wire may_finish = finishing & ~(|unfinished_now);
  assign reports_valid = may_finish & port_free;
  wire finishes = reports_valid & reports_ready;
  assign reports_data[`CBVH_STREAM_REPORT_LAST_INDEX] = last_index;
  assign reports_data[`CBVH_STREAM_REPORT_REPAIRS] = repairs_now & {32{status == `CBVH_STATUS_OK}};
  assign reports_data[`CBVH_STREAM_REPORT_ROOT] = root;
  assign reports_data[`CBVH_STREAM_REPORT_STATUS] = status;

  // A final pair.
  reg [4:0] queued;
  wire [4:0] queued_now = queued - {4'd0, repair_jobs_valid & repair_jobs_ready};
  wire [`CBVH_POINTER_BITS-1:0] index = finals_data[`CBVH_FINAL_PAIR_INDEX];
  wire accepted = finals_data[`CBVH_FINAL_PAIR_STATUS] == `CBVH_STATUS_OK;
  wire last = finals_data[`CBVH_FINAL_PAIR_LAST];
  wire other_line = accepted & holds & ~flushes_for_read & line != index[`CBVH_POINTER_BITS-1:2];
  wire may_take = ~finishing & queued_now <= 5'd14;
  assign finals_ready = may_take & (~other_line | port_free);
  wire takes = finals_valid & finals_ready;
  wire merges = takes & accepted;

  assign memory_valid = repair_requests_valid | (may_finish & reports_ready & holds) |
                        (finals_valid & may_take & other_line);
  assign memory_data = repair_requests_valid & ~wanted ? repair_requests_data : {pairs, mask, line, 1'b1};
  wire sends_line = flushes_for_read | finishes | (takes & other_line);

  wire [4*PAIR-1:0] pairs_kept = pairs & {4 * PAIR{~sends_line}};
  wire [3:0] mask_kept = mask & {4{~sends_line}};
  wire [3:0] slot = (4'd1 << index[1:0]) & {4{merges}};
  wire [PAIR-1:0] pair = finals_data[`CBVH_FINAL_PAIR_PAIR];

  // Its repairs.
  wire [`CBVH_NODE_CODES_WIDTH-1:0] child_0 = pair[`CBVH_NODE_PAIR_CHILD_0];
  wire [`CBVH_NODE_CODES_WIDTH-1:0] child_1 = pair[`CBVH_NODE_PAIR_CHILD_1];
  wire [JOB-1:0] job_0 = {
    finals_data[`CBVH_FINAL_PAIR_REGISTERS],
    finals_data[`CBVH_FINAL_PAIR_AFTER_0],
    finals_data[`CBVH_FINAL_PAIR_BEFORE_0],
    child_0[`CBVH_NODE_CODES_POINTER]
  };
  wire [JOB-1:0] job_1 = {
    finals_data[`CBVH_FINAL_PAIR_REGISTERS],
    finals_data[`CBVH_FINAL_PAIR_AFTER_1],
    finals_data[`CBVH_FINAL_PAIR_BEFORE_1],
    child_1[`CBVH_NODE_CODES_POINTER]
  };
  wire unused_codes = &{child_0, child_1};
  wire [1:0] repair = finals_data[`CBVH_FINAL_PAIR_REPAIR] & {2{merges}};
  wire [1:0] added = {&repair, ^repair};
  final_queue #(
      .WIDTH(JOB),
      .D(2),
      .PLACES_LOG2(4)
  ) queue (
      .clk(clk),
      .reset(reset),
      .in_valid({1'b0, repair}),
      .in_data({{JOB{1'b0}}, job_1, job_0}),
      .out_valid(repair_jobs_valid),
      .out_ready(repair_jobs_ready),
      .out_data(repair_jobs_data)
  );

  wire [`CBVH_POINTER_BITS-1:0] highest_now = index > highest ? index : highest;
  always @(posedge clk) begin
    pairs <= {
      slot[3] ? pair : pairs_kept[4*PAIR-1:3*PAIR],
      slot[2] ? pair : pairs_kept[3*PAIR-1:2*PAIR],
      slot[1] ? pair : pairs_kept[2*PAIR-1:PAIR],
      slot[0] ? pair : pairs_kept[PAIR-1:0]
    };
    if (merges) line <= index[`CBVH_POINTER_BITS-1:2];
    if (takes & last) begin
      last_index <= accepted ? highest_now : index;
      root       <= finals_data[`CBVH_FINAL_PAIR_ROOT];
      status     <= finals_data[`CBVH_FINAL_PAIR_STATUS];
    end
    if (reset) begin
      pairs      <= {4 * PAIR{1'b0}};
      holds      <= 1'b0;
      mask       <= 4'd0;
      finishing  <= 1'b0;
      unfinished <= 6'd0;
      repairs    <= 32'd0;
      highest    <= {`CBVH_POINTER_BITS{1'b0}};
      queued     <= 5'd0;
    end else begin
      holds      <= merges | (holds & ~sends_line);
      mask       <= mask_kept | slot;
      finishing  <= finishing ? ~finishes : takes & last;
      unfinished <= unfinished_now + {4'd0, added};
      repairs    <= finishes ? 32'd0 : repairs_now;
      queued     <= queued_now + {3'd0, added};
      if (takes) highest <= last ? {`CBVH_POINTER_BITS{1'b0}} : highest_now;
    end
  end
endmodule
