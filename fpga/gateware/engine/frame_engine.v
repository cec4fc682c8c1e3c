// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The board's side of docs/board_protocol.md between two streams of bytes: takes frames, keeps batches in block RAM, runs them through
// the unit, answers in order. A frame that is not VECTORS waits until all batches before it are done, and holds up those behind it.
`include "cbvh_board.vh"
module frame_engine #(
    parameter N = 6,
    parameter D = 1,
    parameter BUFFERS = 2,  // batch buffers: 1 or 2
    parameter BUFFER_BITS = 12,  // 2^BUFFER_BITS bytes each, at most 15
    parameter RESULT_BITS = 12,  // 2^RESULT_BITS bytes, at most 15
    parameter CLOCK_KHZ = 12000,
    parameter [255:0] NAME = "cbvh gateware"  // of the board, at most 32 letters
) (
    input  wire       clk,
    input  wire       reset,
    input  wire       in_valid,
    output wire       in_ready,
    input  wire [7:0] in_data,
    output wire       out_valid,
    input  wire       out_ready,
    output wire [7:0] out_data,
    output wire       busy,       // goes on without another byte
    output wire       running,    // a batch
    output wire       listening,  // a frame has begun and not ended
    output wire       is_open     // the unit
);
  localparam [31:0] BUFFER_COUNT = BUFFERS;

  // Frames in.
  wire header_valid, header_taken, wants_payload, payload_valid, end_valid, end_good, skips, receiver_busy;
  wire [7:0] version, kind, payload_data;
  wire [31:0] number, length;
  frame_receiver receiver (
      .clk(clk),
      .reset(reset),
      .in_valid(in_valid),
      .in_ready(in_ready),
      .in_data(in_data),
      .header_valid(header_valid),
      .header_taken(header_taken),
      .wants_payload(wants_payload),
      .version(version),
      .kind(kind),
      .number(number),
      .length(length),
      .payload_valid(payload_valid),
      .payload_data(payload_data),
      .end_valid(end_valid),
      .end_good(end_good),
      .skipped(skips),
      .busy(receiver_busy)
  );
  wire other_version, whole, is_reset;
  assign wants_payload = whole && length != 32'd0;

  // What is still to be answered: batches, then at most one other frame.
  wire [ 1:0] used;  // batch buffers
  reg         pending;
  reg  [ 7:0] pending_kind;  // of the answer
  reg  [ 3:0] pending_reason;  // of an ERROR
  reg  [31:0] pending_number, pending_detail;
  reg         credit_due;

  // The answering half, below.
  localparam [1:0] WAIT = 2'd0, RUN = 2'd1, START = 2'd2, SEND = 2'd3;
  reg  [ 1:0] state;
  reg         answers_pending;
  wire        sender_busy, batch_done, aborts;  // aborts: RESET is being taken

  // The order and the reason to refuse. A frame is judged when all of it is here.
  reg  [31:0] next_number, taken, skipped, corrupted, lost, stale, batches, cycles;
  wire        blocked = pending && !(is_reset && !answers_pending);
  wire        judged = (header_valid && !wants_payload && !blocked) || (end_valid && end_good);
  wire [31:0] ahead = number - next_number;
  wire        counts = judged && !is_reset && !other_version;  // of another version's sequence nothing is known
  wire        takes = counts && !ahead[31];
  assign header_taken = header_valid && !blocked;
  assign aborts = judged && is_reset;

  wire [7:0] answer;
  wire [3:0] refusal;
  wire [15:0] opened_parameters;
  wire [31:0] refusal_detail;
  wire queues, full, keeps;
  frame_judge #(
      .N(N),
      .D(D),
      .BUFFER_BITS(BUFFER_BITS)
  ) judge (
      .clk(clk),
      .reset(reset | aborts),
      .payload_valid(payload_valid),
      .payload_data(payload_data),
      .version(version),
      .kind(kind),
      .length(length),
      .takes(takes),
      .full(full),
      .kept(keeps),
      .other_version(other_version),
      .whole(whole),
      .is_reset(is_reset),
      .answer(answer),
      .refusal(refusal),
      .refusal_detail(refusal_detail),
      .queues(queues),
      .opened(is_open),
      .opened_parameters(opened_parameters)
  );

  // Batches.
  wire [31:0] batch_number;
  wire [BUFFER_BITS:0] batch_length;
  wire [BUFFER_BITS-1:0] batch_next;
  wire [7:0] batch_data;
  batch_queue #(
      .BUFFERS(BUFFERS),
      .BUFFER_BITS(BUFFER_BITS)
  ) batch_buffers (
      .clk(clk),
      .reset(reset | aborts),
      .begins(header_taken),
      .wanted(kind == `CBVH_FRAME_VECTORS && is_open),
      .write(payload_valid),
      .write_data(payload_data),
      .keeps(keeps),
      .push(takes && queues),
      .number(number),
      .length(length[BUFFER_BITS:0]),
      .pop(state == RUN && batch_done),
      .used(used),
      .full(full),
      .first_number(batch_number),
      .first_length(batch_length),
      .read_next(batch_next),
      .read_data(batch_data)
  );
  wire result_write, stepped;
  wire [RESULT_BITS-1:0] result_address;
  wire [7:0] result_data;
  wire [3:0] batch_reason;
  wire [31:0] batch_detail;
  wire [15:0] result_length;
  batch_runner #(
      .N(N),
      .D(D),
      .BUFFER_BITS(BUFFER_BITS),
      .RESULT_BITS(RESULT_BITS)
  ) runner (
      .clk(clk),
      .reset(reset | aborts),
      .start(state == WAIT && used != 2'd0 && !credit_due),
      .length(batch_length),
      .batch_next(batch_next),
      .batch_data(batch_data),
      .result_write(result_write),
      .result_address(result_address),
      .result_data(result_data),
      .done(batch_done),
      .reason(batch_reason),
      .detail(batch_detail),
      .result_length(result_length),
      .stepped(stepped)
  );
  assign running = state == RUN;

  // Answers.
  reg [ 7:0] answer_kind;
  reg [ 3:0] answer_reason;
  reg [31:0] answer_number, answer_detail, send_number;
  reg [15:0] answer_length;
  wire [31:0] credit = next_number + BUFFER_COUNT - {30'd0, used};
  wire [15:0] answer_next;
  wire [7:0] answer_byte;
  answer_payload #(
      .N(N),
      .D(D),
      .BUFFERS(BUFFERS),
      .BUFFER_BITS(BUFFER_BITS),
      .RESULT_BITS(RESULT_BITS),
      .CLOCK_KHZ(CLOCK_KHZ),
      .NAME(NAME)
  ) payload (
      .clk(clk),
      .result_write(result_write),
      .result_address(result_address),
      .result_data(result_data),
      .kind(answer_kind),
      .credit(credit),
      .opened_parameters(opened_parameters),
      .counters({cycles, batches, stale, lost, corrupted, skipped, taken}),
      .reason(answer_reason),
      .number(answer_number),
      .detail(answer_detail),
      .next(answer_next),
      .data(answer_byte)
  );
  frame_sender sender (
      .clk(clk),
      .reset(reset),
      .start(state == START),
      .busy(sender_busy),
      .kind(answer_kind),
      .number(send_number),
      .length(answer_length),
      .payload_next(answer_next),
      .payload_data(answer_byte),
      .out_valid(out_valid),
      .out_ready(out_ready),
      .out_data(out_data)
  );
  assign busy = receiver_busy | (state != WAIT) | (used != 2'd0) | pending | credit_due;
  assign listening = in_ready;

  function [15:0] length_of(input [7:0] frame);
    case (frame)
      `CBVH_FRAME_BOARD_HELLO:  length_of = 16'd100;
      `CBVH_FRAME_BOARD_OPEN:   length_of = 16'd20;
      `CBVH_FRAME_BOARD_STATUS: length_of = 16'd32;
      `CBVH_FRAME_ERROR:        length_of = 16'd16;
      default:                  length_of = 16'd4;
    endcase
  endfunction

  always @(posedge clk) begin
    // The receiving half.
    if (skips) skipped <= skipped + 32'd1;
    if (end_valid && !end_good) corrupted <= corrupted + 32'd1;
    if (stepped) cycles <= cycles + 32'd1;
    if (counts && ahead[31]) stale <= stale + 32'd1;
    if (takes) begin
      next_number <= number + 32'd1;
      taken       <= taken + 32'd1;
      lost        <= lost + ahead;
      if (ahead != 32'd0) credit_due <= 1'b1;
    end
    if ((takes && !queues) || (judged && other_version)) begin
      pending        <= 1'b1;
      pending_kind   <= answer;
      pending_reason <= refusal;
      pending_number <= number;
      pending_detail <= refusal_detail;
    end

    // The answering half: one frame at a time.
    case (state)
      WAIT: begin
        answers_pending <= 1'b0;
        answer_kind     <= credit_due ? `CBVH_FRAME_CREDIT : pending_kind;
        answer_length   <= length_of(credit_due ? `CBVH_FRAME_CREDIT : pending_kind);
        answer_reason   <= pending_reason;
        answer_number   <= pending_number;
        answer_detail   <= pending_kind == `CBVH_FRAME_ERROR && pending_reason == `CBVH_ERROR_CREDIT ? credit : pending_detail;
        if (credit_due) begin
          credit_due <= 1'b0;
          state      <= START;
        end else if (used != 2'd0) state <= RUN;
        else if (pending) begin
          answers_pending <= 1'b1;
          if (pending_kind == `CBVH_FRAME_BOARD_RESET) send_number <= 32'd0;
          state <= START;
        end
      end
      RUN:
      if (batch_done) begin
        answer_kind   <= batch_reason == 4'd0 ? `CBVH_FRAME_RESULTS : `CBVH_FRAME_ERROR;
        answer_length <= batch_reason == 4'd0 ? result_length : 16'd16;
        answer_reason <= batch_reason;
        answer_number <= batch_number;
        answer_detail <= batch_detail;
        if (batch_reason == 4'd0) batches <= batches + 32'd1;
        state <= START;
      end
      START:   state <= SEND;
      default:
      if (!sender_busy) begin
        send_number <= send_number + 32'd1;
        if (answers_pending) pending <= 1'b0;
        answers_pending <= 1'b0;
        state           <= WAIT;
      end
    endcase

    if (aborts) begin
      next_number    <= number + 32'd1;
      pending        <= 1'b1;
      pending_kind   <= `CBVH_FRAME_BOARD_RESET;
      pending_reason <= 4'd0;
      if (state == WAIT || state == RUN) state <= WAIT;
    end
    if (reset | aborts) {credit_due, taken, skipped, corrupted, lost, stale, batches, cycles} <= 225'd0;
    if (reset) begin
      next_number     <= 32'd0;
      send_number     <= 32'd0;
      pending         <= 1'b0;
      answers_pending <= 1'b0;
      state           <= WAIT;
    end
  end
endmodule
