// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Float node pairs in emission order become final node pairs in memory, and repairs of earlier ones. A pair a clock
// while nothing backtracks. A treelet_collector, a line_combiner and a backtrack_unit with the four channels between
// them; what it costs is what they do. Twin of rtl_model/compress/stream_compressor.h; paper figure 2b.
`include "cbvh_constants.vh"
module stream_compressor #(
    parameter N = 6,
    parameter D = 2
) (
    input  wire                                 clk,
    input  wire                                 reset,
    input  wire                                 jobs_valid,
    output wire                                 jobs_ready,
    input  wire [    `CBVH_STREAM_JOB_WIDTH-1:0] jobs_data,
    output wire                                 memory_valid,
    input  wire                                 memory_ready,
    output wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] memory_data,
    input  wire                                 lines_valid,
    output wire                                 lines_ready,
    input  wire [   `CBVH_MEMORY_LINE_WIDTH-1:0] lines_data,
    output wire                                 reports_valid,
    input  wire                                 reports_ready,
    output wire [ `CBVH_STREAM_REPORT_WIDTH-1:0] reports_data
);
  wire finals_in_valid, finals_in_ready, finals_out_valid, finals_out_ready;
  wire [`CBVH_FINAL_PAIR_WIDTH-1:0] finals_in_data, finals_out_data;
  wire repair_jobs_in_valid, repair_jobs_in_ready, repair_jobs_out_valid, repair_jobs_out_ready;
  wire [`CBVH_REPAIR_JOB_WIDTH-1:0] repair_jobs_in_data, repair_jobs_out_data;
  wire repairs_done_in_valid, repairs_done_in_ready, repairs_done_out_valid, repairs_done_out_ready;
  wire [32-1:0] repairs_done_in_data, repairs_done_out_data;
  wire repair_requests_in_valid, repair_requests_in_ready, repair_requests_out_valid, repair_requests_out_ready;
  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] repair_requests_in_data, repair_requests_out_data;

  treelet_collector #(
      .N(N),
      .D(D)
  ) collector (
      .clk(clk),
      .reset(reset),
      .jobs_valid(jobs_valid),
      .jobs_ready(jobs_ready),
      .jobs_data(jobs_data),
      .finals_valid(finals_in_valid),
      .finals_ready(finals_in_ready),
      .finals_data(finals_in_data)
  );
  line_combiner #(
      .N(N)
  ) combiner (
      .clk(clk),
      .reset(reset),
      .finals_valid(finals_out_valid),
      .finals_ready(finals_out_ready),
      .finals_data(finals_out_data),
      .repair_jobs_valid(repair_jobs_in_valid),
      .repair_jobs_ready(repair_jobs_in_ready),
      .repair_jobs_data(repair_jobs_in_data),
      .repairs_done_valid(repairs_done_out_valid),
      .repairs_done_ready(repairs_done_out_ready),
      .repairs_done_data(repairs_done_out_data),
      .repair_requests_valid(repair_requests_out_valid),
      .repair_requests_ready(repair_requests_out_ready),
      .repair_requests_data(repair_requests_out_data),
      .memory_valid(memory_valid),
      .memory_ready(memory_ready),
      .memory_data(memory_data),
      .reports_valid(reports_valid),
      .reports_ready(reports_ready),
      .reports_data(reports_data)
  );
  backtrack_unit #(
      .N(N)
  ) backtrack (
      .clk(clk),
      .reset(reset),
      .jobs_valid(repair_jobs_out_valid),
      .jobs_ready(repair_jobs_out_ready),
      .jobs_data(repair_jobs_out_data),
      .requests_valid(repair_requests_in_valid),
      .requests_ready(repair_requests_in_ready),
      .requests_data(repair_requests_in_data),
      .lines_valid(lines_valid),
      .lines_ready(lines_ready),
      .lines_data(lines_data),
      .done_valid(repairs_done_in_valid),
      .done_ready(repairs_done_in_ready),
      .done_data(repairs_done_in_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_FINAL_PAIR_WIDTH)
  ) finals (
      .clk(clk),
      .reset(reset),
      .in_valid(finals_in_valid),
      .in_ready(finals_in_ready),
      .in_data(finals_in_data),
      .out_valid(finals_out_valid),
      .out_ready(finals_out_ready),
      .out_data(finals_out_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_REPAIR_JOB_WIDTH)
  ) repair_jobs (
      .clk(clk),
      .reset(reset),
      .in_valid(repair_jobs_in_valid),
      .in_ready(repair_jobs_in_ready),
      .in_data(repair_jobs_in_data),
      .out_valid(repair_jobs_out_valid),
      .out_ready(repair_jobs_out_ready),
      .out_data(repair_jobs_out_data)
  );
  skid_buffer #(
      .WIDTH(32)
  ) repairs_done (
      .clk(clk),
      .reset(reset),
      .in_valid(repairs_done_in_valid),
      .in_ready(repairs_done_in_ready),
      .in_data(repairs_done_in_data),
      .out_valid(repairs_done_out_valid),
      .out_ready(repairs_done_out_ready),
      .out_data(repairs_done_out_data)
  );
  skid_buffer #(
      .WIDTH(`CBVH_MEMORY_REQUEST_WIDTH)
  ) repair_requests (
      .clk(clk),
      .reset(reset),
      .in_valid(repair_requests_in_valid),
      .in_ready(repair_requests_in_ready),
      .in_data(repair_requests_in_data),
      .out_valid(repair_requests_out_valid),
      .out_ready(repair_requests_out_ready),
      .out_data(repair_requests_out_data)
  );
endmodule
