// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The own grid of a decoded child along one axis, and the first reason to refuse it. Combinational. Twin of decode_axis
// in rtl_model/datapath/decode_box.h, behind decode_codes; paper fig. 4.
`include "cbvh_constants.vh"
module decode_axis #(
    parameter N = 6
) (
    input  wire signed [ `CBVH_INDEX_BITS-1:0] lower,
    input  wire signed [ `CBVH_INDEX_BITS-1:0] upper,
    input  wire signed [ `CBVH_SCALE_BITS-1:0] scale,
    input  wire signed [ `CBVH_SCALE_BITS-1:0] min_scale,
    input  wire                               figure5,
    output wire signed [ `CBVH_SCALE_BITS-1:0] own_scale,
    output wire signed [ `CBVH_INDEX_BITS-1:0] own_lower,
    output wire        [`CBVH_STATUS_BITS-1:0] status
);
  // The number of cells, less one, is right even if the indices left their range.
  localparam [N+1:0] ONE = 1;
  wire [N+1:0] cells = upper[N+1:0] - lower[N+1:0];
  wire [N+1:0] difference = cells - ONE;
  wire inverted = difference[N+1];
  wire below = scale < min_scale;
  wire wide = ~inverted & figure5 & (&difference[N-1:0]);

  localparam UNCLIPPED = `CBVH_INDEX_BITS + N;
  wire [UNCLIPPED-1:0] unclipped_own_lower;
  own_grid #(
      .N(N),
      .WIDTH(UNCLIPPED)
  ) own (
      .scale(scale),
      .lower({{N{lower[`CBVH_INDEX_BITS-1]}}, lower}),
      .cells(cells[N-1:0]),
      .min_scale(min_scale),
      .figure5(figure5),
      .own_scale(own_scale),
      .own_lower(unclipped_own_lower)
  );
  assign own_lower = unclipped_own_lower[`CBVH_INDEX_BITS-1:0];

  wire lower_beyond, upper_beyond, own_beyond;
  beyond_exact_indices #(
      .WIDTH(`CBVH_INDEX_BITS)
  ) of_lower (
      .index (lower),
      .beyond(lower_beyond)
  );
  beyond_exact_indices #(
      .WIDTH(`CBVH_INDEX_BITS)
  ) of_upper (
      .index (upper),
      .beyond(upper_beyond)
  );
  beyond_exact_indices #(
      .WIDTH(UNCLIPPED)
  ) of_own (
      .index (unclipped_own_lower),
      .beyond(own_beyond)
  );
  wire finer_than_floats = min_scale < -9'sd149;
  // A grid that is refused for its scale or its span has no own index to be judged.
  wire inexact = finer_than_floats | lower_beyond | upper_beyond | (own_beyond & ~below & ~wide);

  assign status = inverted ? `CBVH_STATUS_INVERTED :
                  inexact ? `CBVH_STATUS_BEYOND_EXACTNESS :
                  below ? `CBVH_STATUS_SCALE_BELOW_MINIMUM :
                  wide ? `CBVH_STATUS_TOO_WIDE : `CBVH_STATUS_OK;
endmodule
