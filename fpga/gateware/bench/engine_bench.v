// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The frame engine behind stdin and stdout, for fpga/emulator/gateware_core.cpp. A request is `BYTES CLOCKS` and so many bytes in
// hexadecimal; the simulation then runs until it has taken them and has nothing left to do, but not for more clocks. Its answer is the
// bytes that came out, one a line, and `. LEFT BUSY`: bytes not taken yet, which stay queued, and whether it would go on.
// BYTES -1 is power-on. +stalls=SEED holds both ends back at random. `CBVH_ENGINE is frame_engine, or uart_pins.
module engine_bench;
  parameter N = 6;
  parameter D = 1;
  parameter BUFFERS = 2;
  parameter BUFFER_BITS = 12;
  parameter RESULT_BITS = 12;
  localparam [31:0] STDIN = 32'h80000000;
  localparam QUEUE = 65536;

  reg        clk;
  reg        reset;
  reg        in_valid;
  wire       in_ready;
  reg  [7:0] in_data;
  wire       out_valid;
  reg        out_ready;
  wire [7:0] out_data;
  wire       busy;
  wire       running, listening, is_open;

  `CBVH_ENGINE #(
      .N(N),
      .D(D),
      .BUFFERS(BUFFERS),
      .BUFFER_BITS(BUFFER_BITS),
      .RESULT_BITS(RESULT_BITS),
      .NAME("cbvh gateware in simulation")
  ) engine (
      .clk(clk),
      .reset(reset),
      .in_valid(in_valid),
      .in_ready(in_ready),
      .in_data(in_data),
      .out_valid(out_valid),
      .out_ready(out_ready),
      .out_data(out_data),
      .busy(busy),
      .running(running),
      .listening(listening),
      .is_open(is_open)
  );

  reg [7:0] queue[0:QUEUE-1];
  integer head, tail, count, clocks, fields, value, stalls, seed;

  task step;
    begin
      in_valid  = head != tail && (stalls == 0 || $random(seed) % 4 != 0);
      in_data   = queue[head];
      out_ready = stalls == 0 || $random(seed) % 4 != 0;
      #1;
      if (in_valid & in_ready) head = head + 1;
      if (out_valid & out_ready) $fwrite(1, "%h\n", out_data);
      clk = 1'b1;
      #1;
      clk = 1'b0;
    end
  endtask

  task power_on;
    begin
      reset = 1'b1;
      head  = 0;
      tail  = 0;
      repeat (4) step;
      reset = 1'b0;
    end
  endtask

  initial begin
    clk  = 1'b0;
    stalls = $value$plusargs("stalls=%d", seed);
    power_on;
    fields = $fscanf(STDIN, "%d %d", count, clocks);
    while (fields == 2) begin
      if (count < 0) power_on;
      if (head == tail) begin
        head = 0;
        tail = 0;
      end
      while (count > 0) begin
        fields = $fscanf(STDIN, "%h", value);
        queue[tail] = value;
        tail = tail + 1;
        count = count - 1;
      end
      while (clocks > 0 && (head != tail || busy)) begin
        step;
        clocks = clocks - 1;
      end
      $fwrite(1, ". %0d %0d\n", tail - head, busy !== 1'b0);
      $fflush;
      fields = $fscanf(STDIN, "%d %d", count, clocks);
    end
    $finish(0);
  end
endmodule
