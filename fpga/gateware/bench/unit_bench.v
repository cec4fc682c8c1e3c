// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Runs cases through one unit between two channels, as testbench/rtl/in_out_bench.h runs the C++ module: the same stalls in the same
// cycles, the same end. `UNIT is the module, `PARAMETERS its parameter list; with `HARNESS it is one of ../harness. What it reads and writes:
// README.md.
module unit_bench;
  parameter STIMULUS_WIDTH = 1;
  parameter RESPONSE_WIDTH = 1;
  parameter STIMULI = 1;  // at most
  parameter CASES = 1;  // at most

  reg                       clk;
  reg                       reset;
  reg                       source_valid;
  wire                      source_ready;
  reg  [STIMULUS_WIDTH-1:0] source_data;
  wire                      jobs_valid;
  wire                      jobs_ready;
  wire [STIMULUS_WIDTH-1:0] jobs_data;
  wire                      results_valid;
  wire                      results_ready;
  wire [RESPONSE_WIDTH-1:0] results_data;
  wire                      sink_valid;
  reg                       sink_ready;
  wire [RESPONSE_WIDTH-1:0] sink_data;

  skid_buffer #(STIMULUS_WIDTH) jobs (
      clk, reset, source_valid, source_ready, source_data, jobs_valid, jobs_ready, jobs_data
  );
`ifdef HARNESS
  wire [31:0] results_cycle;
  wire [31:0] sink_cycle;  // in which the event counts as happened
  reg  [ 3:0] memory_delay;
  wire        memory_draws;
  `UNIT `PARAMETERS unit (
      clk, reset, jobs_valid, jobs_ready, jobs_data, results_valid, results_ready, results_data, results_cycle,
      memory_delay, memory_draws
  );
  skid_buffer #(32 + RESPONSE_WIDTH) results (
      clk, reset, results_valid, results_ready, {results_cycle, results_data}, sink_valid, sink_ready,
      {sink_cycle, sink_data}
  );
`else
  wire [31:0] sink_cycle = cycle;
  wire memory_draws = 1'b0;
  reg [3:0] memory_delay;
  `UNIT `PARAMETERS unit (
      clk, reset, jobs_valid, jobs_ready, jobs_data, results_valid, results_ready, results_data
  );
  skid_buffer #(RESPONSE_WIDTH) results (
      clk, reset, results_valid, results_ready, results_data, sink_valid, sink_ready, sink_data
  );
`endif

  reg [STIMULUS_WIDTH-1:0] stimuli[0:STIMULI-1];
  reg [255:0] cases[0:CASES-1];  // seeds of source, sink and memory, stimuli, responses wanted
  integer stimulus_count, case_count, hang_cycles, drain_cycles;
  integer source_stalls, sink_stalls;
  reg [8*1024:1] folder;
  integer trace;

  // SinkStalls of testbench/rtl/ports.h; rtl_model/kernel/stall.h and random.h, one for each end; memory is one of them.
  reg [7:0] sink_clock;
  reg [63:0] source_state, source_left, sink_state, sink_left, memory_state;
  reg source_holds, sink_holds;
  function [63:0] mixed(input [63:0] state);
    reg [63:0] z;
    begin
      z = (state ^ (state >> 30)) * 64'hBF58476D1CE4E5B9;
      z = (z ^ (z >> 27)) * 64'h94D049BB133111EB;
      mixed = z ^ (z >> 31);
    end
  endfunction
  localparam [63:0] GAMMA = 64'h9E3779B97F4A7C15;
  task draw_source_stall;
    begin
      if (source_left == 0) begin
        source_holds = ~source_holds;
        source_left  = mixed(source_state + GAMMA) % 4 == 0 ? 24 : 3;
        source_left  = 1 + mixed(source_state + 2 * GAMMA) % source_left;
        source_state = source_state + 2 * GAMMA;
      end
      source_left = source_left - 1;
    end
  endtask
  task draw_sink_stall;
    begin
      if (sink_left == 0) begin
        sink_holds = ~sink_holds;
        sink_left  = mixed(sink_state + GAMMA) % 4 == 0 ? 24 : 3;
        sink_left  = 1 + mixed(sink_state + 2 * GAMMA) % sink_left;
        sink_state = sink_state + 2 * GAMMA;
      end
      sink_left = sink_left - 1;
    end
  endtask

  integer first, sent, size, wanted, accepted, given, cycle, idle, progress, index;

  // One clock. Inputs change well before its edge and are looked at after they have settled.
  task step;
    begin
      if (source_stalls != 0) draw_source_stall;
      if (sink_stalls != 0) draw_sink_stall;
      source_valid = ~source_holds & (sent < size);
      source_data  = stimuli[sent < size ? first + sent : 0];
      sink_ready   = ~(sink_holds | (sink_stalls != 0 & sink_clock >= 192));
      sink_clock   = sink_clock + 1;
      memory_delay = sink_stalls != 0 ? mixed(memory_state + GAMMA) % 14 : 0;
      #1;
      if (jobs_valid & jobs_ready) begin
        $fwrite(trace, "a %0d\n", cycle);
        accepted = accepted + 1;
      end
      if (sink_valid & sink_ready) begin
        $fwrite(trace, "r %0d %h\n", sink_cycle, sink_data);
        given = given + 1;
      end
      if (source_valid & source_ready) sent = sent + 1;
      if (memory_draws) memory_state = memory_state + GAMMA;
      clk = 1'b1;
      #1;
      clk   = 1'b0;
      cycle = cycle + 1;
    end
  endtask

  task run_case;
    begin
      {source_state, sink_state, memory_state} = cases[index][255:64];
      sink_clock   = sink_state[7:0];
      size         = cases[index][63:32];
      wanted       = cases[index][31:0];
      source_left  = 0;
      sink_left    = 0;
      source_holds = 1'b0;
      sink_holds   = 1'b0;
      source_valid = 1'b0;
      sink_ready   = 1'b0;
      reset        = 1'b1;
      #1 clk = 1'b1;
      #1 clk = 1'b0;
      reset    = 1'b0;
      sent     = 0;
      accepted = 0;
      given    = 0;
      cycle    = 0;
      idle     = 0;
      while ((accepted < size || given < wanted) && idle < hang_cycles) begin
        progress = accepted + given;
        step;
        idle = accepted + given === progress ? idle + 1 : 0;
      end
      repeat (drain_cycles) step;
      $fwrite(trace, "e %0d %0d\n", cycle, idle >= hang_cycles);
      first = first + size;
    end
  endtask

  initial begin
    clk = 1'b0;
    if (!$value$plusargs("folder=%s", folder) || !$value$plusargs("stimuli=%d", stimulus_count) ||
        !$value$plusargs("cases=%d", case_count) || !$value$plusargs("hang=%d", hang_cycles) ||
        !$value$plusargs("drain=%d", drain_cycles)) begin
      $display("unit_bench: wants +folder= +stimuli= +cases= +hang= +drain=");
      $finish;
    end
    source_stalls = $test$plusargs("source_stalls");
    sink_stalls = $test$plusargs("sink_stalls");
    $readmemh({folder, "/stimuli.hex"}, stimuli, 0, stimulus_count - 1);
    $readmemh({folder, "/cases.hex"}, cases, 0, case_count - 1);
    trace = $fopen({folder, "/trace.txt"}, "w");
    first = 0;
    for (index = 0; index < case_count; index = index + 1) run_case;
    $fwrite(trace, "end\n");
    $fclose(trace);
    $finish;
  end
endmodule
