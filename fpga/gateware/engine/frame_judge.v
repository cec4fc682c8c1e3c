// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What a frame is answered with, once all of it is here: docs/board_protocol.md. Knows the unit, and whether it is open.
`include "cbvh_board.vh"
module frame_judge #(
    parameter N = 6,
    parameter D = 1,
    parameter BUFFER_BITS = 12
) (
    input  wire        clk,
    input  wire        reset,
    input  wire        payload_valid,
    input  wire [ 7:0] payload_data,
    input  wire [ 7:0] version,
    input  wire [ 7:0] kind,
    input  wire [31:0] length,
    input  wire        takes,          // the frame, which is all here
    input  wire        full,           // no batch buffer is free
    input  wire        kept,           // the payload is in a batch buffer
    output wire        other_version,
    output wire        whole,          // not too long, and of our version
    output wire        is_reset,
    output reg  [ 7:0] answer,
    output reg  [ 3:0] refusal,        // of an ERROR
    output reg  [31:0] refusal_detail,
    output reg         queues,         // a batch: answered when it has run
    output reg         opened,
    output reg  [15:0] opened_parameters  // N + 256 D
);
  localparam [15:0] N_MASK = `CBVH_UNIT_N_MASK;
  localparam [15:0] D_MASK = `CBVH_UNIT_D_MASK;
  wire unused_parameters = N == D;  // of a unit without them
  localparam [31:0] GREATEST_BATCH = 32'd1 << BUFFER_BITS;
  assign other_version = version != 8'd`CBVH_PROTOCOL_VERSION;
  assign whole = !other_version && length <= GREATEST_BATCH;
  assign is_reset = whole && kind == `CBVH_FRAME_RESET && length == 32'd0;
  reg [63:0] request;  // the last eight bytes of a payload
  wire unit_known = request[31:0] == `CBVH_UNIT_ID;
  wire parameters_known = request[39:36] == 4'd0 && request[47:44] == 4'd0 && N_MASK[request[35:32]] && D_MASK[request[43:40]];

  always @* begin
    answer         = `CBVH_FRAME_ERROR;
    refusal        = 4'd0;
    refusal_detail = 32'd0;
    queues         = 1'b0;
    if (other_version) begin
      refusal        = `CBVH_ERROR_VERSION;
      refusal_detail = 32'd`CBVH_PROTOCOL_VERSION;
    end else if (!whole) begin
      refusal        = `CBVH_ERROR_LENGTH;
      refusal_detail = GREATEST_BATCH;
    end else begin
      case (kind)
        `CBVH_FRAME_HELLO:  if (length == 32'd0) answer = `CBVH_FRAME_BOARD_HELLO; else refusal = `CBVH_ERROR_LENGTH;
        `CBVH_FRAME_STATUS: if (length == 32'd0) answer = `CBVH_FRAME_BOARD_STATUS; else refusal = `CBVH_ERROR_LENGTH;
        `CBVH_FRAME_RESET:  if (length == 32'd0) answer = `CBVH_FRAME_BOARD_RESET; else refusal = `CBVH_ERROR_LENGTH;
        `CBVH_FRAME_OPEN:
        if (length != 32'd8) begin
          refusal        = `CBVH_ERROR_LENGTH;
          refusal_detail = 32'd8;
        end else if (!unit_known) begin
          refusal        = `CBVH_ERROR_UNIT;
          refusal_detail = request[31:0];
        end else if (!parameters_known) begin
          refusal        = `CBVH_ERROR_PARAMETERS;
          refusal_detail = {16'd0, request[47:32]};
        end else answer = `CBVH_FRAME_BOARD_OPEN;
        `CBVH_FRAME_VECTORS:
        if (!opened) refusal = `CBVH_ERROR_NOT_OPEN;
        else if (length == 32'd0 ? full : !kept) refusal = `CBVH_ERROR_CREDIT;
        else if (length < 32'd12) begin
          refusal        = `CBVH_ERROR_LENGTH;
          refusal_detail = 32'd12;
        end else queues = 1'b1;
        default: begin
          refusal        = `CBVH_ERROR_TYPE;
          refusal_detail = {24'd0, kind};
        end
      endcase
    end
  end

  always @(posedge clk) begin
    if (payload_valid) request <= {payload_data, request[63:8]};
    if (takes && whole && kind == `CBVH_FRAME_OPEN) begin
      opened            <= answer == `CBVH_FRAME_BOARD_OPEN;
      opened_parameters <= request[47:32];
    end
    if (reset) opened <= 1'b0;
  end
endmodule
