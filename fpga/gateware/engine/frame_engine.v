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
  localparam [31:0] GREATEST_BATCH = 32'd1 << BUFFER_BITS;
  localparam [31:0] GREATEST_RESULT = 32'd1 << RESULT_BITS;
  localparam MEMORY_BITS = BUFFER_BITS + BUFFERS - 1;
  localparam [31:0] CLOCK = 32'd0 + CLOCK_KHZ;
  localparam [31:0] BUFFER_COUNT = BUFFERS;
  localparam [15:0] N_MASK = `CBVH_UNIT_N_MASK;
  localparam [15:0] D_MASK = `CBVH_UNIT_D_MASK;
  localparam [31:0] STIMULUS_BITS = `CBVH_STIMULUS_WIDTH, RESPONSE_BITS = `CBVH_RESPONSE_WIDTH;
  function [255:0] letters(input [255:0] text);  // the first letter in the lowest byte, zeros behind
    integer i;
    begin
      letters = 256'd0;
      for (i = 0; i < 32; i = i + 1) if (text[8*i+:8] != 8'd0) letters = {letters[247:0], text[8*i+:8]};
    end
  endfunction
  localparam [255:0] LETTERS = letters(NAME);

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
  wire whole = version == 8'd`CBVH_PROTOCOL_VERSION && length <= GREATEST_BATCH;
  wire is_reset = whole && kind == `CBVH_FRAME_RESET && length == 32'd0;
  assign wants_payload = whole && length != 32'd0;

  // What is still to be answered: batches, then at most one other frame.
  reg  [ 1:0] used;  // batch buffers
  reg fill_buffer, run_buffer;
  reg [31:0] batch_number_0, batch_number_1;
  reg [BUFFER_BITS:0] batch_length_0, batch_length_1;
  reg         pending;
  reg  [ 7:0] pending_kind;  // of the answer
  reg  [ 3:0] pending_reason;  // of an ERROR
  reg  [31:0] pending_number, pending_detail;
  reg         credit_due;
  reg         opened;
  reg  [15:0] opened_parameters;  // N + 256 D
  assign is_open = opened;

  // The answering half, below.
  localparam [1:0] WAIT = 2'd0, RUN = 2'd1, START = 2'd2, SEND = 2'd3;
  reg  [ 1:0] state;
  reg         answers_pending;
  wire        sender_busy, batch_done;
  wire        aborts;  // RESET is being taken

  // The order and the reason to refuse. A frame is judged when all of it is here.
  reg  [31:0] next_number, taken, skipped, corrupted, lost, stale, batches, cycles;
  wire        blocked = pending && !(is_reset && !answers_pending);
  wire        judged = (header_valid && !wants_payload && !blocked) || (end_valid && end_good);
  wire [31:0] ahead = number - next_number;
  wire        other_version = version != 8'd`CBVH_PROTOCOL_VERSION;  // of its sequence nothing is known
  wire        counts = judged && !is_reset && !other_version;
  wire        takes = counts && !ahead[31];
  reg         keeps;  // the payload goes into a batch buffer
  reg  [BUFFER_BITS-1:0] fill_at;
  reg  [63:0] request;  // the last eight bytes of a payload
  wire        unit_known = request[31:0] == `CBVH_UNIT_ID;
  wire        parameters_known = request[39:36] == 4'd0 && request[47:44] == 4'd0 && N_MASK[request[35:32]] && D_MASK[request[43:40]];
  assign header_taken = header_valid && !blocked;
  assign aborts = judged && is_reset;

  reg [7:0] answer;
  reg [3:0] refusal;
  reg [31:0] refusal_detail;
  reg queues;  // a batch
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
        else if (length == 32'd0 ? used == BUFFER_COUNT[1:0] : !keeps) refusal = `CBVH_ERROR_CREDIT;
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

  // Batches.
  wire [BUFFER_BITS-1:0] batch_next;
  wire [7:0] batch_data;
  wire [BUFFER_BITS:0] fill_address = {fill_buffer, fill_at}, run_address = {run_buffer, batch_next};
  wire unused_buffer = fill_address[BUFFER_BITS] & run_address[BUFFER_BITS];  // with one buffer
  byte_memory #(
      .ADDRESS_BITS(MEMORY_BITS)
  ) batch_memory (
      .clk(clk),
      .write(payload_valid && keeps),
      .write_address(fill_address[MEMORY_BITS-1:0]),
      .write_data(payload_data),
      .read_address(run_address[MEMORY_BITS-1:0]),
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
      .length(run_buffer ? batch_length_1 : batch_length_0),
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

  // Answers. A word is taken over whole with its first byte, so that it is of one moment.
  reg [7:0] answer_kind;
  reg [15:0] answer_length;
  reg [3:0] answer_reason;
  reg [31:0] answer_number, answer_detail, send_number, word;
  wire [15:0] payload_next;
  wire [7:0] result_byte;
  byte_memory #(
      .ADDRESS_BITS(RESULT_BITS)
  ) result_memory (
      .clk(clk),
      .write(result_write),
      .write_address(result_address),
      .write_data(result_data),
      .read_address(payload_next[RESULT_BITS-1:0]),
      .read_data(result_byte)
  );
  wire [31:0] credit = next_number + BUFFER_COUNT - {30'd0, used};
  localparam [799:0] HELLO = {
    31'd0, 1'd`CBVH_UNIT_STATE, D_MASK, N_MASK, `CBVH_UNIT_NAME, `CBVH_UNIT_ID, 32'd1,
    LETTERS, GREATEST_RESULT, GREATEST_BATCH, CLOCK, BUFFER_COUNT[15:0], 16'd`CBVH_FIRMWARE_VERSION, 32'd0
  };
  reg [31:0] word_next;
  always @* begin
    case (answer_kind)
      `CBVH_FRAME_BOARD_HELLO: word_next = payload_next[6:2] < 5'd25 ? HELLO[{5'd0, payload_next[6:2]}*32+:32] : 32'd0;
      `CBVH_FRAME_BOARD_OPEN:
      case (payload_next[4:2])
        3'd1: word_next = `CBVH_UNIT_ID;
        3'd2: word_next = {16'd0, opened_parameters};
        3'd3: word_next = STIMULUS_BITS;
        default: word_next = RESPONSE_BITS;
      endcase
      `CBVH_FRAME_BOARD_STATUS:
      case (payload_next[4:2])
        3'd1: word_next = taken;
        3'd2: word_next = skipped;
        3'd3: word_next = corrupted;
        3'd4: word_next = lost;
        3'd5: word_next = stale;
        3'd6: word_next = batches;
        default: word_next = cycles;
      endcase
      default:
      case (payload_next[3:2])
        2'd1: word_next = {28'd0, answer_reason};
        2'd2: word_next = answer_number;
        default: word_next = answer_detail;
      endcase
    endcase
    if (payload_next[15:2] == 14'd0) word_next = credit;
  end
  reg [1:0] byte_in_word;
  reg in_memory;
  wire [7:0] word_byte = byte_in_word == 2'd0 ? word[7:0] : byte_in_word == 2'd1 ? word[15:8] :
                         byte_in_word == 2'd2 ? word[23:16] : word[31:24];
  always @(posedge clk) begin
    byte_in_word <= payload_next[1:0];
    in_memory    <= answer_kind == `CBVH_FRAME_RESULTS && payload_next[15:2] != 14'd0;
    if (payload_next[1:0] == 2'd0) word <= word_next;
  end
  frame_sender sender (
      .clk(clk),
      .reset(reset),
      .start(state == START),
      .busy(sender_busy),
      .kind(answer_kind),
      .number(send_number),
      .length(answer_length),
      .payload_next(payload_next),
      .payload_data(in_memory ? result_byte : word_byte),
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
    if (payload_valid) begin
      request <= {payload_data, request[63:8]};
      fill_at <= fill_at + 1'b1;
    end
    if (header_taken) begin
      keeps   <= kind == `CBVH_FRAME_VECTORS && opened && used != BUFFER_COUNT[1:0];
      fill_at <= 0;
    end
    if (counts && ahead[31]) stale <= stale + 32'd1;
    if (takes) begin
      next_number <= number + 32'd1;
      taken       <= taken + 32'd1;
      lost        <= lost + ahead;
      if (ahead != 32'd0) credit_due <= 1'b1;
      if (whole && kind == `CBVH_FRAME_OPEN) begin
        opened            <= answer == `CBVH_FRAME_BOARD_OPEN;
        opened_parameters <= request[47:32];
      end
      if (queues) begin
        fill_buffer <= BUFFERS == 2 && !fill_buffer;
        if (fill_buffer) begin
          batch_number_1 <= number;
          batch_length_1 <= length[BUFFER_BITS:0];
        end else begin
          batch_number_0 <= number;
          batch_length_0 <= length[BUFFER_BITS:0];
        end
      end
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
        answer_number <= run_buffer ? batch_number_1 : batch_number_0;
        answer_detail <= batch_detail;
        run_buffer    <= BUFFERS == 2 && !run_buffer;
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
    used <= used + {1'b0, takes & queues} - {1'b0, state == RUN && batch_done};

    if (aborts) begin
      next_number    <= number + 32'd1;
      pending        <= 1'b1;
      pending_kind   <= `CBVH_FRAME_BOARD_RESET;
      pending_reason <= 4'd0;
      if (state == WAIT || state == RUN) state <= WAIT;
    end
    if (reset | aborts) begin
      {taken, skipped, corrupted, lost, stale, batches, cycles} <= 224'd0;
      {fill_buffer, run_buffer, credit_due, opened} <= 4'd0;
      used <= 2'd0;
    end
    if (reset) begin
      next_number     <= 32'd0;
      send_number     <= 32'd0;
      pending         <= 1'b0;
      answers_pending <= 1'b0;
      state           <= WAIT;
    end
  end
endmodule
