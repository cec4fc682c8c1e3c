// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// fpga/boards/common/uart_board.v at its pins, with the ports of the frame engine, so that engine_bench.v can run it: both ways bytes
// travel as bits on a line. The other end's clock is 2 % slow or fast, by a bit of +stalls=SEED.
module uart_pins #(
    parameter N = 6,
    parameter D = 1,
    parameter BUFFERS = 2,
    parameter BUFFER_BITS = 12,
    parameter RESULT_BITS = 12,
    parameter [255:0] NAME = "cbvh"
) (
    input  wire       clk,
    input  wire       reset,
    input  wire       in_valid,
    output wire       in_ready,
    input  wire [7:0] in_data,
    output reg        out_valid,
    input  wire       out_ready,
    output reg  [7:0] out_data,
    output wire       busy,
    output wire       running,
    output wire       listening,
    output wire       is_open
);
  localparam CLOCKS_PER_BIT = 8;
  wire tx, board_busy;
  reg rx;
  uart_board #(
      .CLOCKS_PER_BIT(CLOCKS_PER_BIT),
      .N(N),
      .D(D),
      .BUFFERS(BUFFERS),
      .BUFFER_BITS(BUFFER_BITS),
      .RESULT_BITS(RESULT_BITS),
      .NAME(NAME)
  ) board (
      .clk(clk),
      .reset(reset),
      .rx(rx),
      .tx(tx),
      .busy(board_busy),
      .running(running),
      .listening(listening),
      .is_open(is_open)
  );

  // Both ends count hundredths of a clock.
  integer bit_length, seed, sending, send_left, taking, take_left, quiet;
  reg [9:0] send_bits;
  reg [7:0] taken;
  assign in_ready = sending == 0;
  assign busy = board_busy | sending != 0 | taking != 0 | out_valid | quiet < 4 * CLOCKS_PER_BIT;
  initial begin
    bit_length = 100 * CLOCKS_PER_BIT;
    if ($value$plusargs("stalls=%d", seed)) bit_length = bit_length * (seed % 2 == 0 ? 98 : 102) / 100;
  end

  always @(posedge clk) begin
    if (in_valid & in_ready) begin
      send_bits = {1'b1, in_data, 1'b0};
      sending   = 10;
      send_left = bit_length;
    end else if (sending != 0) begin
      send_left = send_left - 100;
      if (send_left < 0) begin
        send_left = send_left + bit_length;
        send_bits = {1'b1, send_bits[9:1]};
        sending   = sending - 1;
      end
    end
    rx <= sending == 0 | send_bits[0];

    if (out_valid & out_ready) out_valid <= 1'b0;
    if (taking == 0) begin
      if (tx === 1'b0) begin
        taking    = 10;
        take_left = bit_length / 2;
      end
    end else begin
      take_left = take_left - 100;
      if (take_left < 0) begin
        take_left = take_left + bit_length;
        if (taking != 10 && taking != 1) taken = {tx, taken[7:1]};
        if (taking == 1 && tx === 1'b1) begin
          if (out_valid) $display("uart_pins: a byte was not taken");
          out_valid <= 1'b1;
          out_data  <= taken;
        end
        taking = taking - 1;
      end
    end
    quiet = sending != 0 || taking != 0 || tx === 1'b0 ? 0 : quiet + 1;
    if (reset) begin
      rx        <= 1'b1;
      sending   = 0;
      taking    = 0;
      quiet     = 0;
      out_valid <= 1'b0;
    end
  end
endmodule
