// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Batches in block RAM, first in, first out. A payload is written where the next batch would lie; `push` makes it one. `read_data` is the
// byte of the oldest batch at the `read_next` of the clock before.
module batch_queue #(
    parameter BUFFERS = 2,  // 1 or 2
    parameter BUFFER_BITS = 12  // 2^BUFFER_BITS bytes each
) (
    input  wire                   clk,
    input  wire                   reset,
    input  wire                   begins,      // a payload
    input  wire                   wanted,      // it is one of a batch
    input  wire                   write,
    input  wire [            7:0] write_data,
    output reg                    keeps,       // the payload that has begun
    input  wire                   push,
    input  wire [           31:0] number,
    input  wire [  BUFFER_BITS:0] length,
    input  wire                   pop,
    output reg  [            1:0] used,        // buffers
    output wire                   full,
    output wire [           31:0] first_number,
    output wire [  BUFFER_BITS:0] first_length,
    input  wire [BUFFER_BITS-1:0] read_next,
    output wire [            7:0] read_data
);
  localparam [31:0] BUFFER_COUNT = BUFFERS;
  localparam MEMORY_BITS = BUFFER_BITS + BUFFERS - 1;
  reg fill_buffer, run_buffer;
  reg [31:0] number_0, number_1;
  reg [BUFFER_BITS:0] length_0, length_1;
  reg [BUFFER_BITS-1:0] fill_at;
  assign full = used == BUFFER_COUNT[1:0];
  assign first_number = run_buffer ? number_1 : number_0;
  assign first_length = run_buffer ? length_1 : length_0;

  wire [BUFFER_BITS:0] fill_address = {fill_buffer, fill_at}, run_address = {run_buffer, read_next};
  wire unused_buffer = fill_address[BUFFER_BITS] & run_address[BUFFER_BITS];  // with one buffer
  byte_memory #(
      .ADDRESS_BITS(MEMORY_BITS)
  ) memory (
      .clk(clk),
      .write(write && keeps),
      .write_address(fill_address[MEMORY_BITS-1:0]),
      .write_data(write_data),
      .read_address(run_address[MEMORY_BITS-1:0]),
      .read_data(read_data)
  );

  always @(posedge clk) begin
    if (write) fill_at <= fill_at + 1'b1;
    if (begins) begin
      keeps   <= wanted && !full;
      fill_at <= 0;
    end
    if (push) begin
      fill_buffer <= BUFFERS == 2 && !fill_buffer;
      if (fill_buffer) begin
        number_1 <= number;
        length_1 <= length;
      end else begin
        number_0 <= number;
        length_0 <= length;
      end
    end
    if (pop) run_buffer <= BUFFERS == 2 && !run_buffer;
    used <= used + {1'b0, push} - {1'b0, pop};
    if (reset) begin
      {fill_buffer, run_buffer} <= 2'd0;
      used <= 2'd0;
    end
  end
endmodule
