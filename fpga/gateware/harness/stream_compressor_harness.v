// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A stream compressor with its memory: float pairs in; out, for each tree, its repairs, memory pair by pair, the report.
// Of a refused tree only the report. Repairs wait in a log until the report comes, since a refusal makes them void; then
// the unit's memory port rests until all is told. `out_cycle` is that in which memory took the repair; for the rest that
// in which the report came. Costs the memory, a log of 16 * 2^LINES_LOG2 repairs (what does not fit is lost, and so found
// missing) and a bit for each pair of the memory. See README.md for `out_cycle`, `memory_delay` and `memory_draws`.
`include "cbvh_constants.vh"
module stream_compressor_harness #(
    parameter N = 6,
    parameter D = 2,
    parameter LINES_LOG2 = 8,
    parameter LATENCY = 4
) (
    input  wire                               clk,
    input  wire                               reset,
    input  wire                               in_valid,
    output wire                               in_ready,
    input  wire [  `CBVH_STREAM_JOB_WIDTH-1:0] in_data,
    output wire                               out_valid,
    input  wire                               out_ready,
    output wire [`CBVH_STREAM_EVENT_WIDTH-1:0] out_data,
    output wire [                       31:0] out_cycle,
    input  wire [                        3:0] memory_delay,
    output wire                               memory_draws
);
  localparam PAIR = `CBVH_NODE_PAIR_WIDTH;
  localparam INDEX = `CBVH_POINTER_BITS;
  localparam LOG_LOG2 = LINES_LOG2 + 4;
  localparam LOG_WIDTH = 32 + INDEX + PAIR;
  localparam [1:0] RUN = 2'd0;
  localparam [1:0] REPAIRS = 2'd1;
  localparam [1:0] MEMORY = 2'd2;
  localparam [1:0] REPORT = 2'd3;
  reg [1:0] state;
  reg [31:0] cycle;

  wire unit_memory_valid, unit_memory_ready, requests_valid, requests_ready;
  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] unit_memory_data, requests_data;
  wire memory_valid, memory_ready;
  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] memory_data;
  wire answers_valid, answers_ready, lines_in_valid, lines_in_ready, lines_valid, lines_ready;
  wire [`CBVH_MEMORY_LINE_WIDTH-1:0] answers_data, lines_in_data, lines_data;
  wire unit_reports_valid, unit_reports_ready, reports_valid, reports_ready;
  wire [`CBVH_STREAM_REPORT_WIDTH-1:0] unit_reports_data, reports_data;
  wire [1:0] reports_behind;
  stream_compressor #(
      .N(N),
      .D(D)
  ) unit (
      .clk(clk),
      .reset(reset),
      .jobs_valid(in_valid),
      .jobs_ready(in_ready),
      .jobs_data(in_data),
      .memory_valid(unit_memory_valid),
      .memory_ready(unit_memory_ready),
      .memory_data(unit_memory_data),
      .lines_valid(lines_valid),
      .lines_ready(lines_ready),
      .lines_data(lines_data),
      .reports_valid(unit_reports_valid),
      .reports_ready(unit_reports_ready),
      .reports_data(unit_reports_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_MEMORY_REQUEST_WIDTH)
  ) requests (
      .clk(clk),
      .reset(reset),
      .in_valid(unit_memory_valid),
      .in_ready(unit_memory_ready),
      .in_data(unit_memory_data),
      .out_valid(requests_valid),
      .out_ready(requests_ready),
      .out_data(requests_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_MEMORY_LINE_WIDTH)
  ) lines (
      .clk(clk),
      .reset(reset),
      .in_valid(lines_in_valid),
      .in_ready(lines_in_ready),
      .in_data(lines_in_data),
      .out_valid(lines_valid),
      .out_ready(lines_ready),
      .out_data(lines_data)
  );
  // A report is taken along with the last request that was sent before it. Requests wait while a tree is told, so there
  // can be two; they are counted modulo 4.
  reg [1:0] sent, taken;
  wire sends = unit_memory_valid & unit_memory_ready;
  wire takes = requests_valid & requests_ready;
  wire [1:0] due = reports_behind - taken;
  skid_buffer #(
      .WIDTH(2 + `CBVH_STREAM_REPORT_WIDTH)
  ) reports (
      .clk(clk),
      .reset(reset),
      .in_valid(unit_reports_valid),
      .in_ready(unit_reports_ready),
      .in_data({sent + {1'b0, sends}, unit_reports_data}),
      .out_valid(reports_valid),
      .out_ready(reports_ready),
      .out_data({reports_behind, reports_data})
  );

  // While the tree is told, line after line is read for that.
  reg [`CBVH_LINE_BITS-1:0] told_line;
  reg asked;
  reg [1:0] told_slot;
  wire all_told;
  wire cleared = state == REPORT & out_ready;
  wire all_taken = reports_valid & due == 2'd0;
  assign memory_valid = state == RUN ? requests_valid & ~all_taken : state == MEMORY & ~asked;
  assign requests_ready = state == RUN & memory_ready & ~all_taken;
  assign memory_data = state == RUN ? requests_data : {{4 * PAIR{1'b0}}, 4'd0, told_line, 1'b0};
  assign lines_in_valid = state == RUN & answers_valid;
  assign lines_in_data = answers_data;
  assign answers_ready = state == RUN ? lines_in_ready :
                         state == MEMORY & out_ready & ((&told_slot) | all_told);
  line_memory #(
      .N(N),
      .LINES_LOG2(LINES_LOG2),
      .LATENCY(LATENCY)
  ) memory (
      .clk(clk),
      .reset(reset | cleared),
      .requests_valid(memory_valid),
      .requests_ready(memory_ready),
      .requests_data(memory_data),
      .lines_valid(answers_valid),
      .lines_ready(answers_ready),
      .lines_data(answers_data),
      .delay(memory_delay),
      .draws(memory_draws)
  );

  // A write to a pair that the tree has written before is a repair.
  wire taken_write = takes & requests_data[`CBVH_MEMORY_REQUEST_WRITE];
  wire [`CBVH_LINE_BITS-1:0] line = requests_data[`CBVH_MEMORY_REQUEST_LINE];
  wire [3:0] mask = requests_data[`CBVH_MEMORY_REQUEST_MASK];
  wire [4*PAIR-1:0] pairs = requests_data[`CBVH_MEMORY_REQUEST_PAIRS];
  wire beyond = |(line >> LINES_LOG2);
  reg [(4<<LINES_LOG2)-1:0] written;
  wire [3:0] written_before = written[{line[LINES_LOG2-1:0], 2'd0}+:4];
  wire [3:0] rewritten = mask & written_before;
  wire [1:0] slot = rewritten[0] ? 2'd0 : rewritten[1] ? 2'd1 : rewritten[2] ? 2'd2 : 2'd3;
  wire [1:0] highest_slot = mask[3] ? 2'd3 : mask[2] ? 2'd2 : mask[1] ? 2'd1 : {1'b0, ~mask[0]};
  reg [INDEX-1:0] highest;
  reg [LOG_WIDTH-1:0] log[0:(1<<LOG_LOG2)-1];
  reg [LOG_LOG2:0] logged, told;
  wire logs = taken_write & ~beyond & (|rewritten) & ~logged[LOG_LOG2];
  wire [LOG_WIDTH-1:0] entry = log[told[LOG_LOG2-1:0]];

  reg [`CBVH_STREAM_REPORT_WIDTH-1:0] report;
  reg [31:0] report_cycle;
  assign reports_ready = state == RUN & (due == 2'd0 | due == 2'd1 & takes);
  wire told_pair = state == MEMORY & answers_valid & out_ready;
  assign all_told = {told_line, told_slot} == highest;
  assign out_valid = state == REPAIRS ? told != logged : state == MEMORY ? answers_valid : state == REPORT;
  assign out_cycle = state == REPAIRS ? entry[LOG_WIDTH-1-:32] : report_cycle;
  wire [INDEX-1:0] event_index = state == REPAIRS ? entry[PAIR+:INDEX] : {told_line, told_slot};
  wire [PAIR-1:0] event_pair = state == REPAIRS ? entry[PAIR-1:0] : answers_data[PAIR*told_slot+:PAIR];
  assign out_data[`CBVH_STREAM_EVENT_KIND] = state == REPAIRS ? 2'd0 : state == MEMORY ? 2'd1 : 2'd2;
  assign out_data[`CBVH_STREAM_EVENT_INDEX] = event_index & {INDEX{state != REPORT}};
  assign out_data[`CBVH_STREAM_EVENT_PAIR] = event_pair & {PAIR{state != REPORT}};
  assign out_data[`CBVH_STREAM_EVENT_REPORT] = report & {`CBVH_STREAM_REPORT_WIDTH{state == REPORT}};

  always @(posedge clk) begin
    if (logs) log[logged[LOG_LOG2-1:0]] <= {cycle, line, slot, pairs[PAIR*slot+:PAIR]};
    if (reports_valid & reports_ready) begin
      report       <= reports_data;
      report_cycle <= cycle;
    end
    if (reset) begin
      cycle <= 32'd0;
      sent  <= 2'd0;
      taken <= 2'd0;
    end else begin
      cycle <= cycle + 32'd1;
      if (sends) sent <= sent + 2'd1;
      if (takes) taken <= taken + 2'd1;
    end
    if (reset | cleared) begin
      state     <= RUN;
      written   <= {4 << LINES_LOG2{1'b0}};
      highest   <= {INDEX{1'b0}};
      logged    <= {LOG_LOG2 + 1{1'b0}};
      told      <= {LOG_LOG2 + 1{1'b0}};
      told_line <= {`CBVH_LINE_BITS{1'b0}};
      told_slot <= 2'd0;
      asked     <= 1'b0;
    end else begin
      if (taken_write & ~beyond) written[{line[LINES_LOG2-1:0], 2'd0}+:4] <= written_before | mask;
      if (taken_write & {line, highest_slot} > highest) highest <= {line, highest_slot};
      if (logs) logged <= logged + 1'b1;
      case (state)
        RUN:
        if (reports_valid & reports_ready)
          state <= reports_data[`CBVH_STREAM_REPORT_STATUS] == `CBVH_STATUS_OK ? REPAIRS : REPORT;
        REPAIRS: if (told == logged) state <= MEMORY;
        MEMORY: if (told_pair & all_told) state <= REPORT;
        default: ;
      endcase
      if (state == REPAIRS & out_valid & out_ready) told <= told + 1'b1;
      if (memory_valid & memory_ready & state == MEMORY) asked <= 1'b1;
      else if (told_pair & (&told_slot)) asked <= 1'b0;
      if (told_pair) {told_line, told_slot} <= {told_line, told_slot} + 1'b1;
    end
  end
endmodule
