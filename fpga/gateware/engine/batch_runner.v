// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Runs one batch (docs/board_protocol.md, VECTORS) from a byte memory, and leaves the payload of its RESULTS in another, all but the
// credit. The unit has a clock of its own, which stands still while bytes are fetched and stored: in the unit's cycles nothing ever stalls.
// The unit's inputs change only when that clock falls, so no path between the two clocks is short.
`include "cbvh_board.vh"
module batch_runner #(
    parameter N = 6,
    parameter D = 1,
    parameter BUFFER_BITS = 12,  // batches of at most 2^BUFFER_BITS bytes
    parameter RESULT_BITS = 12   // results likewise
) (
    input  wire                   clk,
    input  wire                   reset,
    input  wire                   start,
    input  wire [  BUFFER_BITS:0] length,
    output wire [BUFFER_BITS-1:0] batch_next,    // the byte wanted in the next clock
    input  wire [            7:0] batch_data,
    output wire                   result_write,
    output wire [RESULT_BITS-1:0] result_address,
    output wire [            7:0] result_data,
    output reg                    done,          // for one clock; then these hold until the next start
    output reg  [            3:0] reason,        // 0, or of the ERROR
    output reg  [           31:0] detail,
    output wire [           15:0] result_length,
    output wire                   stepped        // the unit's clock, for one clock
);
  localparam STIMULUS_BYTES = (`CBVH_STIMULUS_WIDTH + 7) / 8;
  localparam RECORD_BYTES = (`CBVH_RESPONSE_WIDTH + 7) / 8 + 4;
  localparam [23:0] STIMULUS_SIZE = STIMULUS_BYTES;
  localparam [23:0] RECORD_SIZE = RECORD_BYTES;
  localparam [23:0] GREATEST_RESULT = 24'd1 << RESULT_BITS;
  localparam [23:0] FIXED_BATCH = 24'd12;
  localparam [23:0] FIXED_RESULT = 24'd16;
  localparam LINES_LOG2 = BUFFER_BITS > 12 ? BUFFER_BITS - 4 : 8;  // no episode fills more of the unit's memory
  localparam RECORD_PADDING = 8 * (RECORD_BYTES - 4) - `CBVH_RESPONSE_WIDTH;

  localparam [3:0] IDLE = 4'd0, FIXED = 4'd1, WALK = 4'd2, COUNTS = 4'd3, MULTIPLY = 4'd4, EPISODE = 4'd5, BEGIN = 4'd6, RESET = 4'd7,
                   LOAD = 4'd8, DECIDE = 4'd9, LOOK = 4'd10, EDGE = 4'd11, STAMP = 4'd12, STORE = 4'd13, COUNT = 4'd14, FINISH = 4'd15;
  reg [3:0] state;
  reg running;  // the first pass over the batch checks its sizes, the second runs it

  // Sizes: stimuli and responses times their bytes, a bit a clock.
  reg  [23:0] batch_size, result_size, stimuli_bytes, records_bytes;
  reg         too_many;
  wire        too_long = batch_size > {{(23 - BUFFER_BITS) {1'b0}}, length};
  wire        fits = result_size <= GREATEST_RESULT;

  // The batch's bytes: read_data is always the byte at `at`.
  reg  [15:0] at;
  reg  [ 7:0] left;  // bytes to read or write in this state
  reg  [63:0] field;  // the last eight bytes read, the oldest lowest; or four to be written
  reg  [31:0] hang_cycles;
  reg  [15:0] drain_cycles, episodes, episodes_left;
  wire        last = left == 8'd1;
  wire        reads = state == FIXED || state == COUNTS || state == LOAD;
  wire [15:0] at_next = state == IDLE ? 16'd0 :
                        state == WALK ? (episodes_left == 16'd0 ? FIXED_BATCH[15:0] : batch_size[15:0]) : reads ? at + 16'd1 : at;
  assign batch_next = at_next[BUFFER_BITS-1:0];

  // The unit.
  reg                             unit_clk;
  reg                             unit_reset;
  reg                             source_valid;
  reg  [    8*STIMULUS_BYTES-1:0] stimulus;
  reg  [      8*RECORD_BYTES-1:0] record;
  wire                            source_ready, taken, sink_valid;
  wire [`CBVH_RESPONSE_WIDTH-1:0] sink_data;
  wire [31:0] sink_cycle;
  unit_socket #(
      .N(N),
      .D(D),
      .LINES_LOG2(LINES_LOG2)
  ) socket (
      .clk(unit_clk),
      .reset(unit_reset),
      .source_valid(source_valid),
      .source_ready(source_ready),
      .source_data(stimulus[`CBVH_STIMULUS_WIDTH-1:0]),
      .taken(taken),
      .sink_valid(sink_valid),
      .sink_ready(1'b1),
      .sink_data(sink_data),
      .sink_cycle(sink_cycle)
  );

  // An episode.
  reg  [15:0] to_send, to_accept, to_give, stored, drain_left, out, header_at, room;
  reg  [31:0] cycle, cycles, idle_left;
  reg took, pushed, popped, surplus, draining, more;
  wire [31:0] latency;
  latency_meter #(
      .STIMULUS_BYTES(STIMULUS_BYTES),
      .BUFFER_BITS(BUFFER_BITS)
  ) meter (
      .clk(clk),
      .begins(state == BEGIN),
      .looks(state == LOOK),
      .takes(state == EDGE && took),
      .gives(state == STAMP),
      .cycle(cycle),
      .sink_cycle(sink_cycle),
      .latency(latency)
  );

  // Results: the records where the last one ended, all else at header_at.
  wire [15:0] write_at = state == STORE ? out : header_at;
  assign result_write = (state == FIXED && left > 8'd8) || state == STORE || state == COUNT || state == FINISH;
  assign result_address = write_at[RESULT_BITS-1:0];
  wire unused_write_at = |write_at[15:RESULT_BITS];
  assign result_data = state == FIXED ? batch_data : state == STORE ? record[7:0] : field[7:0];
  assign result_length = out;
  assign stepped = state == EDGE;

  task refuse(input [3:0] why, input [23:0] what);
    begin
      reason <= why;
      detail <= what == 24'hFFFFFF ? 32'hFFFFFFFF : {8'd0, what};
      done   <= 1'b1;
      state  <= IDLE;
    end
  endtask
  task load_or_decide(input loads);
    begin
      left  <= STIMULUS_SIZE[7:0];
      state <= loads ? LOAD : DECIDE;
    end
  endtask

  always @(posedge clk) begin
    done     <= 1'b0;
    unit_clk <= state == LOOK || (state == RESET && left == 8'd4);
    at       <= at_next;
    left     <= left - 8'd1;
    if (reads) field <= {batch_data, field[63:8]};
    if (result_write) begin
      if (state == STORE) out <= out + 16'd1;
      else header_at <= header_at + 16'd1;
    end
    case (state)
      IDLE: begin
        left        <= 8'd12;
        batch_size  <= FIXED_BATCH;
        result_size <= FIXED_RESULT;
        header_at   <= 16'd4;
        out         <= FIXED_RESULT[15:0];
        cycles      <= 32'd0;
        too_many    <= 1'b0;
        running     <= 1'b0;
        if (start) begin
          reason <= 4'd0;
          state  <= FIXED;
        end
      end
      FIXED: begin
        if (too_long) refuse(`CBVH_ERROR_LENGTH, FIXED_BATCH);
        else if (last) begin
          {episodes, drain_cycles, hang_cycles} <= {batch_data, field[63:8]};
          episodes_left <= {batch_data, field[63:56]};
          state <= WALK;
        end
      end
      WALK: begin
        left          <= 8'd8;
        too_many      <= too_many | ~fits;
        stimuli_bytes <= STIMULUS_SIZE;
        records_bytes <= RECORD_SIZE;
        batch_size    <= batch_size + 24'd8;
        result_size   <= result_size + 24'd4;
        room          <= GREATEST_RESULT[15:0] - result_size[15:0];
        if (episodes_left != 16'd0) state <= COUNTS;
        else if (batch_size != {{(23 - BUFFER_BITS) {1'b0}}, length}) refuse(`CBVH_ERROR_LENGTH, batch_size);
        else if (too_many | ~fits) refuse(`CBVH_ERROR_RESPONSES, GREATEST_RESULT);
        else begin
          running       <= 1'b1;
          episodes_left <= episodes;
          state         <= EPISODE;
        end
      end
      COUNTS:
      if (!running && too_long) refuse(`CBVH_ERROR_LENGTH, batch_size);
      else if (last) begin
        episodes_left <= episodes_left - 16'd1;
        left          <= 8'd16;
        state         <= running ? BEGIN : MULTIPLY;
      end
      MULTIPLY: begin
        field         <= {1'b0, field[63:33], 1'b0, field[31:1]};
        stimuli_bytes <= stimuli_bytes << 1;
        records_bytes <= records_bytes << 1;
        if (field[0]) batch_size <= batch_size + stimuli_bytes;
        if (field[32] && !too_many) result_size <= result_size + records_bytes;
        if (left == 8'd16 && field[63:48] != 16'd0) too_many <= 1'b1;
        if (left == 8'd16 && field[31:16] != 16'd0) refuse(`CBVH_ERROR_LENGTH, 24'hFFFFFF);
        else if (last) state <= WALK;
      end
      EPISODE: begin
        left <= 8'd8;
        if (episodes_left != 16'd0) state <= COUNTS;
        else begin
          field     <= {16'd0, episodes, cycles};
          header_at <= 16'd8;
          state     <= FINISH;
        end
      end
      BEGIN: begin
        to_send      <= field[15:0];
        to_accept    <= field[15:0];
        to_give      <= field[47:32];
        stored       <= 16'd0;
        cycle        <= 32'd0;
        idle_left    <= hang_cycles;
        drain_left   <= drain_cycles;
        draining     <= 1'b0;
        more         <= 1'b0;
        header_at    <= out;
        out          <= out + 16'd4;
        source_valid <= 1'b0;
        unit_reset   <= 1'b1;
        left         <= 8'd5;
        state        <= RESET;
      end
      RESET: begin
        if (left == 8'd2) unit_reset <= 1'b0;
        if (last) load_or_decide(to_send != 16'd0);
      end
      LOAD: begin
        stimulus <= {batch_data, stimulus[8*STIMULUS_BYTES-1:8]};
        if (last) begin
          source_valid <= 1'b1;
          state        <= DECIDE;
        end
      end
      DECIDE: begin
        left         <= 8'd4;
        field[31:16] <= {idle_left == 32'd0 && !draining, more, 14'd0};
        field[15:0]  <= stored;
        if (!draining && to_accept == 16'd0 && to_give == 16'd0) draining <= 1'b1;
        else if (draining ? drain_left == 16'd0 : idle_left == 32'd0) state <= COUNT;
        else state <= LOOK;
      end
      LOOK: begin
        took   <= taken;
        pushed <= source_valid & source_ready;
        popped <= sink_valid;
        record <= {{RECORD_PADDING{1'b0}}, sink_data, 32'd0};
        state  <= EDGE;
      end
      EDGE: begin
        record[31:0] <= latency;
        cycle        <= cycle + 32'd1;
        cycles       <= cycles + 32'd1;
        surplus      <= to_give == 16'd0;
        if (draining) drain_left <= drain_left - 16'd1;
        idle_left <= took | popped ? hang_cycles : idle_left - 32'd1;
        if (took) to_accept <= to_accept - 16'd1;
        if (popped && to_give != 16'd0) to_give <= to_give - 16'd1;
        if (pushed) begin
          to_send      <= to_send - 16'd1;
          source_valid <= 1'b0;
        end
        if (popped) state <= STAMP;
        else load_or_decide(pushed && to_send != 16'd1);
      end
      STAMP:
      if (surplus && room < RECORD_SIZE[15:0]) begin
        more <= 1'b1;
        load_or_decide(pushed && to_send != 16'd0);
      end else begin
        if (surplus) room <= room - RECORD_SIZE[15:0];
        stored <= stored + 16'd1;
        left   <= RECORD_SIZE[7:0];
        state  <= STORE;
      end
      STORE: begin
        record <= record >> 8;
        if (last) load_or_decide(pushed && to_send != 16'd0);
      end
      COUNT: begin
        field <= field >> 8;
        if (last) state <= EPISODE;
      end
      default: begin
        field <= field >> 8;
        if (last) begin
          done  <= 1'b1;
          state <= IDLE;
        end
      end
    endcase
    if (reset) begin
      state      <= IDLE;
      done       <= 1'b0;
      unit_clk   <= 1'b0;
      unit_reset <= 1'b0;
    end
  end
endmodule
