// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What came in LENGTH clocks ago; LENGTH is 0 or more. From 3 on a memory of LENGTH - 1 words that is read into a
// register and written at the same place, for block RAM; its content has no reset.
module delay_line #(
    parameter WIDTH  = 1,
    parameter LENGTH = 3
) (
    input  wire             clk,
    input  wire             reset,
    input  wire [WIDTH-1:0] in_data,
    output wire [WIDTH-1:0] out_data
);
  generate
    if (LENGTH == 0) begin : wires
      wire unused_clock = clk & reset;
      assign out_data = in_data;
    end else if (LENGTH < 3) begin : registers
      wire unused_reset = reset;
      reg [WIDTH*LENGTH-1:0] stages;
      if (LENGTH == 1) begin : one
        always @(posedge clk) stages <= in_data;
      end else begin : two
        always @(posedge clk) stages <= {stages[WIDTH-1:0], in_data};
      end
      assign out_data = stages[WIDTH*LENGTH-1-:WIDTH];
    end else begin : memory
      localparam PLACE_BITS = $clog2(LENGTH - 1);
      localparam [31:0] LAST = LENGTH - 2;
      reg [WIDTH-1:0] words[0:LENGTH-2];
      reg [PLACE_BITS-1:0] place;
      reg [WIDTH-1:0] oldest;
      assign out_data = oldest;
      always @(posedge clk) begin
        words[place] <= in_data;
        oldest <= words[place];
        if (reset) place <= {PLACE_BITS{1'b0}};
        else place <= place == LAST[PLACE_BITS-1:0] ? {PLACE_BITS{1'b0}} : place + 1'b1;
      end
    end
  endgenerate
endmodule
