// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// iCE40UP5K boards whose clock is 12 MHz and whose serial line is a FT2232H, as on the iCEBreaker. No PLL.
module top (
    input  wire clk_12mhz,
    input  wire uart_rx,
    output wire uart_tx,
    output wire led_red_n,
    output wire led_green_n
);
  reg [7:0] since_start = 8'd0;
  reg reset = 1'b1;
  always @(posedge clk_12mhz) begin
    since_start <= (&since_start) ? since_start : since_start + 8'd1;
    reset       <= ~&since_start;
  end
  wire unused_busy, running, unused_listening, is_open;
  uart_board #(
      .CLOCKS_PER_BIT(`CBVH_CLOCKS_PER_BIT),
      .CLOCK_KHZ(`CBVH_CLOCK_KHZ),
      .N(`CBVH_N),
      .BUFFERS(`CBVH_BUFFERS),
      .NAME("iCE40UP5K board")
  ) board (
      .clk(clk_12mhz),
      .reset(reset),
      .rx(uart_rx),
      .tx(uart_tx),
      .busy(unused_busy),
      .running(running),
      .listening(unused_listening),
      .is_open(is_open)
  );
  assign led_red_n   = ~running;
  assign led_green_n = ~is_open;
endmodule
