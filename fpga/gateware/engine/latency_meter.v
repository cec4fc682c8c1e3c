// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The latency of the response that the sink is taking: of a unit with state from the first stimulus of the episode on, else from the
// response's own.
`include "cbvh_board.vh"
module latency_meter #(
    parameter STIMULUS_BYTES = 1,
    parameter BUFFER_BITS = 12  // of the batch: no more stimuli than fit
) (
    input  wire        clk,
    input  wire        begins,      // an episode
    input  wire        looks,       // at the unit, before its clock rises
    input  wire        takes,       // the unit a stimulus
    input  wire        gives,       // the unit a response, in the clock after `latency` was wanted
    input  wire [31:0] cycle,       // of the unit
    input  wire [31:0] sink_cycle,  // in which the event happened, of a unit with memory
    output wire [31:0] latency
);
`ifdef CBVH_UNIT_MEMORY
  reg [31:0] event_cycle;
  always @(posedge clk) if (looks) event_cycle <= sink_cycle;
`else
  wire [31:0] event_cycle = cycle;
  wire unused_sink = looks & (|sink_cycle);
`endif
  generate
    if (`CBVH_UNIT_STATE) begin : of_first_stimulus
      wire unused_gives = gives;
      reg [31:0] first;
      reg any;
      always @(posedge clk) begin
        if (begins) any <= 1'b0;
        if (takes && !any) begin
          any   <= 1'b1;
          first <= cycle;
        end
      end
      assign latency = any ? event_cycle - first : 32'd0;
    end else begin : of_own_stimulus
      localparam INDEX_BITS = BUFFER_BITS - $clog2(STIMULUS_BYTES + 1) + 1;
      reg [INDEX_BITS:0] accepted, given;
      wire [31:0] own;
      byte_memory #(
          .ADDRESS_BITS(INDEX_BITS),
          .WIDTH(32)
      ) accepted_cycles (
          .clk(clk),
          .write(takes),
          .write_address(accepted[INDEX_BITS-1:0]),
          .write_data(cycle),
          .read_address(given[INDEX_BITS-1:0]),
          .read_data(own)
      );
      always @(posedge clk) begin
        if (begins) begin
          accepted <= 0;
          given    <= 0;
        end
        if (takes) accepted <= accepted + 1'b1;
        if (gives && given != accepted) given <= given + 1'b1;
      end
      assign latency = given != accepted ? event_cycle - own : 32'd0;
    end
  endgenerate
endmodule
