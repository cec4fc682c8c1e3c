// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A board whose link is a serial line: all that does not depend on the device. What comes while the engine is not looking waits in a
// queue; what does not fit there is lost, and the link sends it again.
module uart_board #(
    parameter CLOCKS_PER_BIT = 16,
    parameter CLOCK_KHZ = 48000,
    parameter N = 6,
    parameter D = 1,
    parameter BUFFERS = 2,
    parameter BUFFER_BITS = 11,
    parameter RESULT_BITS = 11,
    parameter QUEUE_BITS = 10,
    parameter [255:0] NAME = "cbvh"
) (
    input  wire clk,
    input  wire reset,
    input  wire rx,
    output wire tx,
    output wire busy,
    output wire running,
    output wire listening,
    output wire is_open
);
  wire rx_valid, rx_ready, in_valid, in_ready, out_valid, out_ready;
  wire [7:0] rx_data, in_data, out_data;
  uart_rx #(
      .CLOCKS_PER_BIT(CLOCKS_PER_BIT)
  ) receiver (
      .clk(clk),
      .reset(reset),
      .line(rx),
      .valid(rx_valid),
      .ready(rx_ready),
      .data(rx_data)
  );
  byte_fifo #(
      .ADDRESS_BITS(QUEUE_BITS)
  ) queue (
      .clk(clk),
      .reset(reset),
      .in_valid(rx_valid),
      .in_ready(rx_ready),
      .in_data(rx_data),
      .out_valid(in_valid),
      .out_ready(in_ready),
      .out_data(in_data)
  );
  wire engine_busy;
  frame_engine #(
      .N(N),
      .D(D),
      .BUFFERS(BUFFERS),
      .BUFFER_BITS(BUFFER_BITS),
      .RESULT_BITS(RESULT_BITS),
      .CLOCK_KHZ(CLOCK_KHZ),
      .NAME(NAME)
  ) engine (
      .clk(clk),
      .reset(reset),
      .in_valid(in_valid),
      .in_ready(in_ready),
      .in_data(in_data),
      .out_valid(out_valid),
      .out_ready(out_ready),
      .out_data(out_data),
      .busy(engine_busy),
      .running(running),
      .listening(listening),
      .is_open(is_open)
  );
  uart_tx #(
      .CLOCKS_PER_BIT(CLOCKS_PER_BIT)
  ) sender (
      .clk(clk),
      .reset(reset),
      .valid(out_valid),
      .ready(out_ready),
      .data(out_data),
      .line(tx)
  );
  assign busy = engine_busy | rx_valid | in_valid | ~out_ready;
endmodule
