// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The unit of this gateware (a CBVH_UNIT_x macro chooses it: cbvh_board.vh) between its two channels. `source_*` fill the channel in,
// `sink_*` empty the channel out; `taken`: the unit takes a stimulus at the next edge. A unit with a memory port
// runs in its harness, with 4 * 2^LINES_LOG2 pairs of memory; `sink_cycle` is then the cycle in which the event happened.
`include "cbvh_board.vh"
module unit_socket #(
    parameter N = 6,
    parameter D = 1,
    parameter LINES_LOG2 = 8
) (
    input  wire                           clk,
    input  wire                           reset,
    input  wire                           source_valid,
    output wire                           source_ready,
    input  wire [`CBVH_STIMULUS_WIDTH-1:0] source_data,
    output wire                           taken,
    output wire                           sink_valid,
    input  wire                           sink_ready,
    output wire [`CBVH_RESPONSE_WIDTH-1:0] sink_data,
    output wire [                    31:0] sink_cycle
);
  wire unused_parameters = N == D && D == LINES_LOG2;  // of a unit without them
  wire                            stimuli_valid;
  wire                            stimuli_ready;
  wire [`CBVH_STIMULUS_WIDTH-1:0] stimuli_data;
  wire                            responses_valid;
  wire                            responses_ready;
  wire [`CBVH_RESPONSE_WIDTH-1:0] responses_data;
  skid_buffer #(
      .WIDTH(`CBVH_STIMULUS_WIDTH)
  ) stimuli (
      .clk(clk),
      .reset(reset),
      .in_valid(source_valid),
      .in_ready(source_ready),
      .in_data(source_data),
      .out_valid(stimuli_valid),
      .out_ready(stimuli_ready),
      .out_data(stimuli_data)
  );
`ifdef CBVH_UNIT_MEMORY
  wire [31:0] responses_cycle;
  wire        unused_draws;
  `CBVH_UNIT `CBVH_UNIT_PARAMETERS unit (
      clk, reset, stimuli_valid, stimuli_ready, stimuli_data, responses_valid, responses_ready, responses_data,
      responses_cycle, 4'd0, unused_draws
  );
  skid_buffer #(
      .WIDTH(32 + `CBVH_RESPONSE_WIDTH)
  ) responses (
      .clk(clk),
      .reset(reset),
      .in_valid(responses_valid),
      .in_ready(responses_ready),
      .in_data({responses_cycle, responses_data}),
      .out_valid(sink_valid),
      .out_ready(sink_ready),
      .out_data({sink_cycle, sink_data})
  );
`else
  assign sink_cycle = 32'd0;
  `CBVH_UNIT `CBVH_UNIT_PARAMETERS unit (
      clk, reset, stimuli_valid, stimuli_ready, stimuli_data, responses_valid, responses_ready, responses_data
  );
  skid_buffer #(
      .WIDTH(`CBVH_RESPONSE_WIDTH)
  ) responses (
      .clk(clk),
      .reset(reset),
      .in_valid(responses_valid),
      .in_ready(responses_ready),
      .in_data(responses_data),
      .out_valid(sink_valid),
      .out_ready(sink_ready),
      .out_data(sink_data)
  );
`endif
  assign taken = stimuli_valid & stimuli_ready;
endmodule
