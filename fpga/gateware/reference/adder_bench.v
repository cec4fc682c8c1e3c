// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Reads `A B` a line from +file=F, and writes the sum of each to stdout.
module adder_bench;
  reg clk, valid;
  reg [63:0] operands;
  wire ready, sum_valid;
  wire [31:0] sum;
  binary32_adder adder (
      clk, 1'b0, valid, ready, operands, sum_valid, 1'b1, sum
  );
  reg [8*1024:1] name;
  integer file, fields, left;
  task step;
    begin
      #1 clk = 1'b1;
      #1 clk = 1'b0;
      if (sum_valid === 1'b1) $display("%h", sum);
    end
  endtask
  initial begin
    clk = 1'b0;
    valid = 1'b1;
    if (!$value$plusargs("file=%s", name)) $finish(0);
    file = $fopen(name, "r");
    fields = $fscanf(file, "%h %h", operands[31:0], operands[63:32]);
    while (fields == 2) begin
      step;
      fields = $fscanf(file, "%h %h", operands[31:0], operands[63:32]);
    end
    valid = 1'b0;
    repeat (3) step;
    $finish(0);
  end
endmodule
