// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Finds frames in a stream of bytes: docs/board_protocol.md. A window of 16 bytes slides over the stream until it holds a header with a
// right checksum; what slides out of it is skipped. The header is then shown until `header_taken`; with `wants_payload` the payload
// follows, a byte a `payload_valid`, and its verdict for one clock.
`include "cbvh_board.vh"
module frame_receiver (
    input  wire        clk,
    input  wire        reset,
    input  wire        in_valid,
    output wire        in_ready,
    input  wire [ 7:0] in_data,
    output wire        header_valid,
    input  wire        header_taken,
    input  wire        wants_payload,
    output wire [ 7:0] version,
    output wire [ 7:0] kind,
    output wire [31:0] number,
    output wire [31:0] length,
    output wire        payload_valid,
    output wire [ 7:0] payload_data,
    output wire        end_valid,
    output wire        end_good,
    output wire        skipped,       // a byte, in this clock
    output wire        busy           // goes on without another byte
);
  localparam [2:0] HUNT = 3'd0, CHECK = 3'd1, HEADER = 3'd2, PAYLOAD = 3'd3, CHECKSUM = 3'd4, VERDICT = 3'd5;
  reg  [  2:0] state;
  reg  [127:0] window;  // the oldest byte in the lowest bits
  reg  [  4:0] filled;  // bytes of it
  reg  [ 31:0] crc;
  reg  [ 15:0] left;  // bytes of payload, or of the checksum being looked at

  wire         full = filled == 5'd16;
  wire         magic = window[15:0] == `CBVH_FRAME_MAGIC;
  wire         moves = in_valid & in_ready;
  wire [  7:0] checked_byte = state == CHECK ? window[7:0] : in_data;
  wire [ 31:0] crc_next;
  wire         last = left[15:1] == 15'd0;
  crc32c_byte crc_of_byte (
      .state(crc),
      .data (checked_byte),
      .next (crc_next)
  );

  assign in_ready      = state == PAYLOAD || state == CHECKSUM || (state == HUNT && !(full && magic));
  assign header_valid  = state == HEADER;
  assign {length, number, kind, version} = window[95:16];
  assign payload_valid = state == PAYLOAD && moves;
  assign payload_data  = in_data;
  assign end_valid     = state == VERDICT;
  assign end_good      = crc == `CBVH_CRC32C_RESIDUE;
  assign skipped       = (state == HUNT && full && moves) || (state == CHECK && last && crc_next != `CBVH_CRC32C_RESIDUE);
  assign busy          = state == CHECK || state == HEADER || state == VERDICT || (full && magic);

  always @(posedge clk) begin
    case (state)
      HUNT: begin
        if (moves) begin
          window <= {in_data, window[127:8]};
          if (!full) filled <= filled + 5'd1;
        end
        crc  <= 32'hFFFFFFFF;
        left <= 16'd16;
        if (full && magic) state <= CHECK;
      end
      CHECK: begin  // the window turns once, so that it is as before
        window <= {window[7:0], window[127:8]};
        crc    <= crc_next;
        left   <= left - 16'd1;
        if (last) begin
          state  <= crc_next == `CBVH_CRC32C_RESIDUE ? HEADER : HUNT;
          filled <= 5'd15;
        end
      end
      HEADER: begin
        crc    <= 32'hFFFFFFFF;
        left   <= length[15:0];  // `wants_payload` comes with no more than that
        filled <= 5'd0;
        if (header_taken) state <= wants_payload ? PAYLOAD : HUNT;
      end
      PAYLOAD, CHECKSUM: begin
        if (moves) begin
          crc  <= crc_next;
          left <= last ? 16'd4 : left - 16'd1;
          if (last) state <= state == PAYLOAD ? CHECKSUM : VERDICT;
        end
      end
      default: state <= HUNT;
    endcase
    if (reset) begin
      state  <= HUNT;
      filled <= 5'd0;
    end
  end
endmodule
