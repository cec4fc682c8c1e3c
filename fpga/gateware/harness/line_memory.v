// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// An ideal memory of 4 * 2^LINES_LOG2 node pairs: takes a request a clock, in order, and answers a read LATENCY clocks
// after taking it (3 at least), or `delay` clocks later; `draws` says that a read is being taken, and so a delay used.
// What was not written since the reset reads as zeros, and so does what lies beyond the end. Costs the pairs and a bit
// for each of them, and 16 lines of answers. Twin of rtl_model/memory/fixed_latency_memory.h.
`include "cbvh_constants.vh"
module line_memory #(
    parameter N = 6,
    parameter LINES_LOG2 = 8,
    parameter LATENCY = 4
) (
    input  wire                                 clk,
    input  wire                                 reset,
    input  wire                                 requests_valid,
    output wire                                 requests_ready,
    input  wire [`CBVH_MEMORY_REQUEST_WIDTH-1:0] requests_data,
    output wire                                 lines_valid,
    input  wire                                 lines_ready,
    output wire [   `CBVH_MEMORY_LINE_WIDTH-1:0] lines_data,
    input  wire [                          3:0] delay,
    output wire                                 draws
);
  localparam PAIR_WIDTH = `CBVH_NODE_PAIR_WIDTH;
  localparam LINES = 1 << LINES_LOG2;

  wire [`CBVH_LINE_BITS-1:0] line = requests_data[`CBVH_MEMORY_REQUEST_LINE];
  wire [LINES_LOG2-1:0] address = line[LINES_LOG2-1:0];
  wire beyond = |(line >> LINES_LOG2);
  wire taken = requests_valid & requests_ready;
  wire write = requests_data[`CBVH_MEMORY_REQUEST_WRITE];
  wire [4*PAIR_WIDTH-1:0] new_pairs = requests_data[`CBVH_MEMORY_REQUEST_PAIRS];
  wire [3:0] write_mask = requests_data[`CBVH_MEMORY_REQUEST_MASK] & {4{taken & write & ~beyond}};
  assign draws = taken & ~write;

  // Read in the clock in which the request is taken, put among the answers one clock later.
  wire [`CBVH_MEMORY_LINE_WIDTH-1:0] line_read;
  reg reading;
  reg [3:0] place_read;
  genvar slot;
  generate
    for (slot = 0; slot < `CBVH_PAIRS_PER_LINE; slot = slot + 1) begin : slots
      reg [PAIR_WIDTH-1:0] pairs[0:LINES-1];
      reg [LINES-1:0] written;
      reg [PAIR_WIDTH-1:0] pair_read;
      reg is_written;
      assign line_read[PAIR_WIDTH*slot+:PAIR_WIDTH] = is_written ? pair_read : {PAIR_WIDTH{1'b0}};
      always @(posedge clk) begin
        if (write_mask[slot]) pairs[address] <= new_pairs[PAIR_WIDTH*slot+:PAIR_WIDTH];
        pair_read  <= pairs[address];
        is_written <= written[address] & ~beyond;
        if (reset) written <= {LINES{1'b0}};
        else if (write_mask[slot]) written[address] <= 1'b1;
      end
    end
  endgenerate

  reg [`CBVH_MEMORY_LINE_WIDTH-1:0] answers[0:15];
  reg [31:0] ready_cycles[0:15];
  reg [3:0] head;
  reg [4:0] count;
  reg [31:0] cycle;
  wire [3:0] tail = head + count[3:0];
  wire pop = lines_valid & lines_ready;
  localparam [31:0] LATENCY_BITS = LATENCY;
  assign lines_valid = (|count) & (ready_cycles[head] <= cycle);
  assign lines_data = answers[head];
  assign requests_ready = ~count[4] | pop;

  always @(posedge clk) begin
    if (draws) ready_cycles[tail] <= cycle + LATENCY_BITS - 32'd1 + {28'd0, delay};
    if (reading) answers[place_read] <= line_read;
    place_read <= tail;
    if (reset) begin
      reading <= 1'b0;
      head    <= 4'd0;
      count   <= 5'd0;
      cycle   <= 32'd0;
    end else begin
      reading <= draws;
      head    <= head + {3'd0, pop};
      count   <= count + {4'd0, draws} - {4'd0, pop};
      cycle   <= cycle + 32'd1;
    end
  end
endmodule
