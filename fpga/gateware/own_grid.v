// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The own grid of a node that spans so many cells, modulo 2^N, of its parent's grid, and its lower index there.
// Combinational. Twin of refinement and own_grid in rtl_model/datapath/cell_index.h; rule 4.
`include "cbvh_constants.vh"
module own_grid #(
    parameter N = 6,
    parameter WIDTH = `CBVH_INDEX_BITS  // of the indices
) (
    input  wire signed [`CBVH_SCALE_BITS-1:0] scale,
    input  wire signed [           WIDTH-1:0] lower,
    input  wire        [              N-1:0] cells,
    input  wire signed [`CBVH_SCALE_BITS-1:0] min_scale,
    input  wire                              figure5,
    output wire signed [`CBVH_SCALE_BITS-1:0] own_scale,
    output wire signed [           WIDTH-1:0] own_lower
);
  wire [3:0] finer;
  leading_zeros #(
      .WIDTH(N),
      .BITS (4)
  ) refinement (
      .value(figure5 ? cells : cells - 1'b1),
      .zeros(finer)
  );
  wire signed [`CBVH_SCALE_BITS:0] wanted = scale - $signed({6'd0, finer});
  wire held = wanted < $signed({min_scale[`CBVH_SCALE_BITS-1], min_scale});
  wire [3:0] shift = scale[3:0] - own_scale[3:0];
  assign own_scale = held ? min_scale : wanted[`CBVH_SCALE_BITS-1:0];
  assign own_lower = lower << shift;
endmodule
