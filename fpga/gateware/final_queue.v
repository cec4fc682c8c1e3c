// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A queue that takes up to 2^D - 1 entries a clock, those of the lanes that are valid, in their order, and gives one.
// Whoever writes keeps count: there is no word of a full queue. Banks of memory: entry i lies in bank i mod 2^D, so
// that no bank is written twice a clock. Costs 2^PLACES_LOG2 entries, read at once, and a crossbar of 2^D - 1 by 2^D
// entries. Twin of FinalQueue in rtl_model/compress/treelet.h.
module final_queue #(
    parameter WIDTH = 1,
    parameter D = 2,
    parameter PLACES_LOG2 = 6
) (
    input  wire                       clk,
    input  wire                       reset,
    input  wire [         (1<<D)-2:0] in_valid,
    input  wire [((1<<D)-1)*WIDTH-1:0] in_data,
    output wire                       out_valid,
    input  wire                       out_ready,
    output wire [          WIDTH-1:0] out_data
);
  localparam BANKS = 1 << D;
  localparam LANES = BANKS - 1;
  localparam ROW_BITS = PLACES_LOG2 - D;
  reg [PLACES_LOG2:0] head;
  reg [PLACES_LOG2:0] tail;
  wire pop = out_valid & out_ready;
  assign out_valid = head != tail;

  // The place of a lane: behind those of the lanes before it.
  wire [LANES*D-1:0] bank_of_lane;
  genvar lane, bank;
  generate
    for (lane = 0; lane < LANES; lane = lane + 1) begin : lanes
      if (lane == 0) begin : first
        assign bank_of_lane[0+:D] = tail[D-1:0];
      end else begin : others
        wire [D-1:0] before_it;
        count_ones #(
            .WIDTH(lane),
            .BITS (D)
        ) earlier (
            .value(in_valid[lane-1:0]),
            .ones (before_it)
        );
        assign bank_of_lane[lane*D+:D] = tail[D-1:0] + before_it;
      end
    end
  endgenerate
  wire [D:0] added;
  count_ones #(
      .WIDTH(LANES),
      .BITS (D + 1)
  ) all_lanes (
      .value(in_valid),
      .ones (added)
  );

  wire [BANKS*WIDTH-1:0] read;
  wire [ROW_BITS-1:0] tail_row = tail[PLACES_LOG2-1:D];
  generate
    for (bank = 0; bank < BANKS; bank = bank + 1) begin : banks
      localparam [31:0] NUMBER = bank;
      reg [WIDTH-1:0] entries[0:(1<<ROW_BITS)-1];
      reg [WIDTH-1:0] entry;
      reg write;
      integer i;
      always @(*) begin
        entry = {WIDTH{1'b0}};
        write = 1'b0;
        for (i = 0; i < LANES; i = i + 1) begin
          if (in_valid[i] & bank_of_lane[i*D+:D] == NUMBER[D-1:0]) begin
            entry = in_data[i*WIDTH+:WIDTH];
            write = 1'b1;
          end
        end
      end
      wire [D:0] beyond_tail = {1'b0, NUMBER[D-1:0]} - {1'b0, tail[D-1:0]};
      wire [ROW_BITS-1:0] row = tail_row + {{ROW_BITS - 1{1'b0}}, beyond_tail[D]};
      always @(posedge clk) if (write) entries[row] <= entry;
      assign read[bank*WIDTH+:WIDTH] = entries[head[PLACES_LOG2-1:D]];
    end
  endgenerate
  assign out_data = read[head[D-1:0]*WIDTH+:WIDTH];

  always @(posedge clk) begin
    if (reset) begin
      head <= {PLACES_LOG2 + 1{1'b0}};
      tail <= {PLACES_LOG2 + 1{1'b0}};
    end else begin
      head <= head + {{PLACES_LOG2{1'b0}}, pop};
      tail <= tail + {{PLACES_LOG2 - D{1'b0}}, added};
    end
  end
endmodule
