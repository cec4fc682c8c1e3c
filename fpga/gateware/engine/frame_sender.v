// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Sends one frame: docs/board_protocol.md. `start` when it is not busy; kind, number and length must hold until it is done. The payload
// is asked for by position: `payload_data` is the byte at the `payload_next` of the clock before.
`include "cbvh_board.vh"
module frame_sender (
    input  wire        clk,
    input  wire        reset,
    input  wire        start,
    output wire        busy,
    input  wire [ 7:0] kind,
    input  wire [31:0] number,
    input  wire [15:0] length,
    output wire [15:0] payload_next,
    input  wire [ 7:0] payload_data,
    output wire        out_valid,
    input  wire        out_ready,
    output wire [ 7:0] out_data
);
  localparam [1:0] IDLE = 2'd0, HEADER = 2'd1, PAYLOAD = 2'd2, CHECKSUM = 2'd3;
  reg [ 1:0] state;
  reg [15:0] position;
  reg [31:0] crc;
  reg        valid;
  reg [ 7:0] data;

  wire       moves = state != IDLE && (!valid || out_ready);
  wire       in_checksum = state == CHECKSUM || (state == HEADER && position[3:2] == 2'd3);
  wire       last = state == HEADER ? position[3:0] == 4'd15 :
                    state == PAYLOAD ? position == length - 16'd1 : position[1:0] == 2'd3;
  wire [31:0] word = in_checksum ? ~crc :
                     position[3:2] == 2'd0 ? {kind, 8'd`CBVH_PROTOCOL_VERSION, `CBVH_FRAME_MAGIC} :
                     position[3:2] == 2'd1 ? number : {16'd0, length};
  wire [7:0] word_byte = position[1:0] == 2'd0 ? word[7:0] :
                         position[1:0] == 2'd1 ? word[15:8] :
                         position[1:0] == 2'd2 ? word[23:16] : word[31:24];
  wire [7:0] data_next = state == PAYLOAD ? payload_data : word_byte;
  wire [31:0] crc_next;
  crc32c_byte crc_of_byte (
      .state(crc),
      .data (data_next),
      .next (crc_next)
  );

  assign busy = state != IDLE || valid;
  assign payload_next = state != PAYLOAD ? 16'd0 : moves ? position + 16'd1 : position;
  assign out_valid = valid;
  assign out_data = data;

  always @(posedge clk) begin
    if (start) begin
      state    <= HEADER;
      position <= 16'd0;
      crc      <= 32'hFFFFFFFF;
    end
    if (moves) begin
      data     <= data_next;
      position <= last ? 16'd0 : position + 16'd1;
      if (!in_checksum) crc <= crc_next;
      else if (last) crc <= 32'hFFFFFFFF;
      if (last) state <= state == HEADER && length != 16'd0 ? PAYLOAD : state == PAYLOAD ? CHECKSUM : IDLE;
    end
    valid <= moves | (valid & ~out_ready);
    if (reset) begin
      state <= IDLE;
      valid <= 1'b0;
    end
  end
endmodule
