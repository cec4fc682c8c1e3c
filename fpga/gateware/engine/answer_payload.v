// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The payload of an answer, byte by byte: `data` is the byte at the `next` of the clock before. RESULTS come from the memory that the
// batch runner fills, all but their credit; of the rest a word is taken over whole with its first byte, so that it is of one moment.
`include "cbvh_board.vh"
module answer_payload #(
    parameter N = 6,
    parameter D = 1,
    parameter BUFFERS = 2,
    parameter BUFFER_BITS = 12,
    parameter RESULT_BITS = 12,
    parameter CLOCK_KHZ = 12000,
    parameter [255:0] NAME = "cbvh gateware"
) (
    input  wire                   clk,
    input  wire                   result_write,
    input  wire [RESULT_BITS-1:0] result_address,
    input  wire [            7:0] result_data,
    input  wire [            7:0] kind,
    input  wire [           31:0] credit,
    input  wire [           15:0] opened_parameters,
    input  wire [          223:0] counters,           // of STATUS, the first lowest
    input  wire [            3:0] reason,             // of ERROR
    input  wire [           31:0] number,
    input  wire [           31:0] detail,
    input  wire [           15:0] next,
    output wire [            7:0] data
);
  localparam [15:0] N_MASK = `CBVH_UNIT_N_MASK;
  localparam [15:0] D_MASK = `CBVH_UNIT_D_MASK;
  wire unused_parameters = N == D;  // of a unit without them
  localparam [31:0] GREATEST_BATCH = 32'd1 << BUFFER_BITS;
  localparam [31:0] GREATEST_RESULT = 32'd1 << RESULT_BITS;
  localparam [31:0] CLOCK = 32'd0 + CLOCK_KHZ;
  localparam [31:0] BUFFER_COUNT = BUFFERS;
  localparam [31:0] STIMULUS_BITS = `CBVH_STIMULUS_WIDTH, RESPONSE_BITS = `CBVH_RESPONSE_WIDTH;
  function [255:0] letters(input [255:0] text);  // the first letter in the lowest byte, zeros behind
    integer i;
    begin
      letters = 256'd0;
      for (i = 0; i < 32; i = i + 1) if (text[8*i+:8] != 8'd0) letters = {letters[247:0], text[8*i+:8]};
    end
  endfunction
  localparam [255:0] LETTERS = letters(NAME);
  localparam [799:0] HELLO = {
    31'd0, 1'd`CBVH_UNIT_STATE, D_MASK, N_MASK, `CBVH_UNIT_NAME, `CBVH_UNIT_ID, 32'd1,
    LETTERS, GREATEST_RESULT, GREATEST_BATCH, CLOCK, BUFFER_COUNT[15:0], 16'd`CBVH_FIRMWARE_VERSION, 32'd0
  };

  wire [7:0] result_byte;
  byte_memory #(
      .ADDRESS_BITS(RESULT_BITS)
  ) results (
      .clk(clk),
      .write(result_write),
      .write_address(result_address),
      .write_data(result_data),
      .read_address(next[RESULT_BITS-1:0]),
      .read_data(result_byte)
  );

  reg [31:0] word, word_next;
  always @* begin
    case (kind)
      `CBVH_FRAME_BOARD_HELLO: word_next = next[6:2] < 5'd25 ? HELLO[{5'd0, next[6:2]}*32+:32] : 32'd0;
      `CBVH_FRAME_BOARD_OPEN:
      case (next[4:2])
        3'd1: word_next = `CBVH_UNIT_ID;
        3'd2: word_next = {16'd0, opened_parameters};
        3'd3: word_next = STIMULUS_BITS;
        default: word_next = RESPONSE_BITS;
      endcase
      `CBVH_FRAME_BOARD_STATUS:
      case (next[4:2])
        3'd1: word_next = counters[31:0];
        3'd2: word_next = counters[63:32];
        3'd3: word_next = counters[95:64];
        3'd4: word_next = counters[127:96];
        3'd5: word_next = counters[159:128];
        3'd6: word_next = counters[191:160];
        default: word_next = counters[223:192];
      endcase
      default:
      case (next[3:2])
        2'd1: word_next = {28'd0, reason};
        2'd2: word_next = number;
        default: word_next = detail;
      endcase
    endcase
    if (next[15:2] == 14'd0) word_next = credit;
  end
  reg [1:0] byte_in_word;
  reg in_memory;
  wire [7:0] word_byte = byte_in_word == 2'd0 ? word[7:0] : byte_in_word == 2'd1 ? word[15:8] :
                         byte_in_word == 2'd2 ? word[23:16] : word[31:24];
  always @(posedge clk) begin
    byte_in_word <= next[1:0];
    in_memory    <= kind == `CBVH_FRAME_RESULTS && next[15:2] != 14'd0;
    if (next[1:0] == 2'd0) word <= word_next;
  end
  assign data = in_memory ? result_byte : word_byte;
endmodule
