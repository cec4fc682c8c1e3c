// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A backtrack unit with its memory: steps of an episode in, events out, in the order in which they left the unit. A
// step that fills memory waits until the unit has reported; that takes no cycle of those which `out_cycle` counts. See
// README.md for `out_cycle`, `memory_delay` and `memory_draws`.
`include "cbvh_constants.vh"
module backtrack_unit_harness #(
    parameter N = 6,
    parameter LINES_LOG2 = 8,
    parameter LATENCY = 4
) (
    input  wire                                  clk,
    input  wire                                  reset,
    input  wire                                  in_valid,
    output wire                                  in_ready,
    input  wire [ `CBVH_BACKTRACK_STEP_WIDTH-1:0] in_data,
    output wire                                  out_valid,
    input  wire                                  out_ready,
    output wire [`CBVH_BACKTRACK_EVENT_WIDTH-1:0] out_data,
    output reg  [                          31:0] out_cycle,
    input  wire [                           3:0] memory_delay,
    output wire                                  memory_draws
);
  localparam PAIR_WIDTH = `CBVH_NODE_PAIR_WIDTH;
  wire unit_requests_valid, unit_requests_ready, requests_valid, requests_ready;
  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] unit_requests_data, requests_data;
  wire memory_valid, memory_ready;
  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] memory_data;
  wire memory_lines_valid, memory_lines_ready, lines_valid, lines_ready;
  wire [`CBVH_MEMORY_LINE_WIDTH-1:0] memory_lines_data, lines_data;
  wire unit_done_valid, unit_done_ready, done_valid, done_ready;
  wire [31:0] unit_done_data, done_data;

  // A job is held back while the report before it is, so that no write of its own can overtake that.
  wire is_job = in_data[`CBVH_BACKTRACK_STEP_REPAIR];
  wire idle;
  wire jobs_valid = in_valid & is_job & (~done_valid | done_ready);
  wire fills = in_valid & ~is_job & idle & ~requests_valid;
  assign in_ready = is_job ? idle & (~done_valid | done_ready) : idle & ~requests_valid & memory_ready;
  backtrack_unit #(
      .N(N)
  ) unit (
      .clk(clk),
      .reset(reset),
      .jobs_valid(jobs_valid),
      .jobs_ready(idle),
      .jobs_data(in_data[`CBVH_BACKTRACK_STEP_JOB]),
      .requests_valid(unit_requests_valid),
      .requests_ready(unit_requests_ready),
      .requests_data(unit_requests_data),
      .lines_valid(lines_valid),
      .lines_ready(lines_ready),
      .lines_data(lines_data),
      .done_valid(unit_done_valid),
      .done_ready(unit_done_ready),
      .done_data(unit_done_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_MEMORY_REQUEST_WIDTH)
  ) requests (
      .clk(clk),
      .reset(reset),
      .in_valid(unit_requests_valid),
      .in_ready(unit_requests_ready),
      .in_data(unit_requests_data),
      .out_valid(requests_valid),
      .out_ready(requests_ready),
      .out_data(requests_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_MEMORY_LINE_WIDTH)
  ) lines (
      .clk(clk),
      .reset(reset),
      .in_valid(memory_lines_valid),
      .in_ready(memory_lines_ready),
      .in_data(memory_lines_data),
      .out_valid(lines_valid),
      .out_ready(lines_ready),
      .out_data(lines_data)
  );
  skid_buffer #(
      .WIDTH(32)
  ) done (
      .clk(clk),
      .reset(reset),
      .in_valid(unit_done_valid),
      .in_ready(unit_done_ready),
      .in_data(unit_done_data),
      .out_valid(done_valid),
      .out_ready(done_ready),
      .out_data(done_data)
  );

  wire [PAIR_WIDTH-1:0] fill_pair = in_data[`CBVH_BACKTRACK_STEP_PAIR];
  wire [`CBVH_POINTER_BITS-1:0] fill_index = in_data[`CBVH_BACKTRACK_STEP_INDEX];
  wire [3:0] fill_mask = 4'd1 << fill_index[1:0];
  wire writes = requests_valid & requests_data[`CBVH_MEMORY_REQUEST_WRITE];
  assign memory_valid = fills | (requests_valid & (~writes | out_ready));
  assign requests_ready = memory_ready & (~writes | out_ready);
  assign memory_data =
      requests_valid ? requests_data : {{4{fill_pair}}, fill_mask, fill_index[`CBVH_POINTER_BITS-1:2], 1'b1};
  line_memory #(
      .N(N),
      .LINES_LOG2(LINES_LOG2),
      .LATENCY(LATENCY)
  ) memory (
      .clk(clk),
      .reset(reset),
      .requests_valid(memory_valid),
      .requests_ready(memory_ready),
      .requests_data(memory_data),
      .lines_valid(memory_lines_valid),
      .lines_ready(memory_lines_ready),
      .lines_data(memory_lines_data),
      .delay(memory_delay),
      .draws(memory_draws)
  );

  // A write is an event when memory takes it.
  wire [3:0] mask = requests_data[`CBVH_MEMORY_REQUEST_MASK];
  wire [1:0] slot = mask[0] ? 2'd0 : mask[1] ? 2'd1 : mask[2] ? 2'd2 : {2{mask[3]}};
  wire [4*PAIR_WIDTH-1:0] pairs = requests_data[`CBVH_MEMORY_REQUEST_PAIRS];
  wire [PAIR_WIDTH-1:0] pair = pairs[PAIR_WIDTH*slot+:PAIR_WIDTH];
  wire [`CBVH_LINE_BITS-1:0] line = requests_data[`CBVH_MEMORY_REQUEST_LINE];
  assign done_ready = out_ready & ~writes;
  assign out_valid = writes ? memory_ready : done_valid;
  assign out_data[`CBVH_BACKTRACK_EVENT_DONE] = ~writes;
  assign out_data[`CBVH_BACKTRACK_EVENT_INDEX] = {line, slot} & {`CBVH_POINTER_BITS{writes}};
  assign out_data[`CBVH_BACKTRACK_EVENT_PAIR] = pair & {PAIR_WIDTH{writes}};
  assign out_data[`CBVH_BACKTRACK_EVENT_REPAIRS] = done_data & {32{~writes}};

  reg started;
  always @(posedge clk) begin
    if (reset) begin
      out_cycle <= 32'd0;
      started   <= 1'b0;
    end else begin
      if (~(started | in_valid) | ~idle | jobs_valid) out_cycle <= out_cycle + 32'd1;
      started <= started | in_valid;
    end
  end
endmodule
