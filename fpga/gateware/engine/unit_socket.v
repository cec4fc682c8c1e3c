// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The unit of this gateware (a CBVH_UNIT_x macro chooses it: cbvh_board.vh) between its two channels. `source_*` fill the channel in,
// `sink_*` empty the channel out; `taken`: the unit takes a stimulus at the next edge.
`include "cbvh_board.vh"
module unit_socket #(
    parameter N = 6,
    parameter D = 1
) (
    input  wire                           clk,
    input  wire                           reset,
    input  wire                           source_valid,
    output wire                           source_ready,
    input  wire [`CBVH_STIMULUS_WIDTH-1:0] source_data,
    output wire                           taken,
    output wire                           sink_valid,
    input  wire                           sink_ready,
    output wire [`CBVH_RESPONSE_WIDTH-1:0] sink_data
);
  wire unused_parameters = N == D;  // of a unit without them
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
  assign taken = stimuli_valid & stimuli_ready;
endmodule
