// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// iCE40-HX8K breakout board (iCE40HX8K-B-EVN): the second channel of its FT2232H is the serial line, its 12 MHz the clock.
// CBVH_DIVF, CBVH_DIVQ, CBVH_CLOCK_KHZ and CBVH_CLOCKS_PER_BIT come from scripts/fpga.
module top (
    input  wire       clk_12mhz,
    input  wire       uart_rx,
    output wire       uart_tx,
    output wire [7:0] led
);
  wire clk, locked;
  SB_PLL40_CORE #(
      .FEEDBACK_PATH("SIMPLE"),
      .DIVR(4'd0),
      .DIVF(`CBVH_DIVF),
      .DIVQ(`CBVH_DIVQ),
      .FILTER_RANGE(3'd1)
  ) pll (
      .REFERENCECLK(clk_12mhz),
      .PLLOUTCORE(clk),
      .LOCK(locked),
      .RESETB(1'b1),
      .BYPASS(1'b0)
  );
  reg [7:0] since_lock = 8'd0;
  reg reset = 1'b1;
  always @(posedge clk) begin
    since_lock <= !locked ? 8'd0 : (&since_lock) ? since_lock : since_lock + 8'd1;
    reset      <= ~&since_lock;
  end
  wire busy, running, listening, is_open;
  uart_board #(
      .CLOCKS_PER_BIT(`CBVH_CLOCKS_PER_BIT),
      .CLOCK_KHZ(`CBVH_CLOCK_KHZ),
      .N(`CBVH_N),
      .BUFFERS(`CBVH_BUFFERS),
      .NAME("iCE40-HX8K breakout board")
  ) board (
      .clk(clk),
      .reset(reset),
      .rx(uart_rx),
      .tx(uart_tx),
      .busy(busy),
      .running(running),
      .listening(listening),
      .is_open(is_open)
  );
  // From left to right: clock locked, unit open, a batch runs, the engine works, it takes bytes, -, the two lines.
  assign led = {~uart_rx, ~uart_tx, 1'b0, listening, busy, running, is_open, locked};
endmodule
