// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// CRC-32C (Castagnoli, reflected) of one more byte. Start with all ones; the checksum is the complement of the state. The state after
// a message and its checksum is always `CBVH_CRC32C_RESIDUE. Combinational.
module crc32c_byte (
    input  wire [31:0] state,
    input  wire [ 7:0] data,
    output wire [31:0] next
);
  function [31:0] advanced(input [31:0] from);
    integer i;
    begin
      advanced = from;
      for (i = 0; i < 8; i = i + 1) advanced = {1'b0, advanced[31:1]} ^ (advanced[0] ? 32'h82F63B78 : 32'd0);
    end
  endfunction
  assign next = advanced(state ^ {24'd0, data});
endmodule
