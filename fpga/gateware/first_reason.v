// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Of some reasons to refuse, the one with the lowest number; ok if there is none. Combinational. Twin of first_reason in
// rtl_model/datapath/pair_compress.h.
`include "cbvh_constants.vh"
module first_reason #(
    parameter COUNT = 6
) (
    input  wire [COUNT*`CBVH_STATUS_BITS-1:0] reasons,
    output reg  [      `CBVH_STATUS_BITS-1:0] first
);
  integer i;
  reg [`CBVH_STATUS_BITS-1:0] reason;
  always @(*) begin
    first = `CBVH_STATUS_OK;
    for (i = 0; i < COUNT; i = i + 1) begin
      reason = reasons[`CBVH_STATUS_BITS*i+:`CBVH_STATUS_BITS];
      if (first == `CBVH_STATUS_OK || (reason != `CBVH_STATUS_OK && reason < first)) first = reason;
    end
  end
endmodule
