// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Whether a context change invalidates the pair that was encoded with it. Combinational. Twin of invalidates in
// rtl_model/datapath/codes.h; rule 9.
`include "cbvh_constants.vh"
module context_changed (
    input  wire [`CBVH_CONTEXT_WIDTH-1:0] old_context,
    input  wire [`CBVH_CONTEXT_WIDTH-1:0] new_context,
    input  wire                           relative,
    output wire                           changed
);
  wire [`CBVH_CONTEXT_WIDTH-1:0] different = old_context ^ new_context;
  wire scale = (|different[`CBVH_CONTEXT_X_SCALE]) | (|different[`CBVH_CONTEXT_Y_SCALE]) |
               (|different[`CBVH_CONTEXT_Z_SCALE]);
  wire lower = (|different[`CBVH_CONTEXT_X_LOWER]) | (|different[`CBVH_CONTEXT_Y_LOWER]) |
               (|different[`CBVH_CONTEXT_Z_LOWER]);
  assign changed = scale | (relative & lower);
endmodule
