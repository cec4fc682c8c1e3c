// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// One axis of one child of a stored pair, re-encoded from the grid it was written with to a coarser one, and the
// child's own grid before and after. Combinational. Twin of decode_codes, coarsen, context_of_cells and store_code in
// rtl_model/datapath/codes.h and reencode.h; rules 4, 5, 7.
`include "cbvh_constants.vh"
module reencode_axis #(
    parameter N = 6
) (
    input  wire        [              N-1:0] lo,
    input  wire        [              N-1:0] hi,
    input  wire signed [`CBVH_SCALE_BITS-1:0] old_scale,
    input  wire signed [`CBVH_INDEX_BITS-1:0] old_lower,
    input  wire signed [`CBVH_SCALE_BITS-1:0] new_scale,
    input  wire signed [`CBVH_INDEX_BITS-1:0] new_lower,
    input  wire signed [`CBVH_SCALE_BITS-1:0] min_scale,
    input  wire                              figure5,
    input  wire                              relative,
    output wire        [              N-1:0] new_lo,
    output wire        [              N-1:0] new_hi,
    output wire        [`CBVH_SCALE_BITS-1:0] scale_before,
    output wire        [`CBVH_INDEX_BITS-1:0] lower_before,
    output wire        [`CBVH_SCALE_BITS-1:0] scale_after,
    output wire        [`CBVH_INDEX_BITS-1:0] lower_after
);
  wire signed [`CBVH_INDEX_BITS-1:0] old_from, old_to;
  decode_codes #(
      .N(N)
  ) old_cells (
      .lo(lo),
      .hi(hi),
      .parent_lower(old_lower),
      .relative(relative),
      .lower(old_from),
      .upper(old_to)
  );

  // On the new one: the floor of the lower edge, the ceiling of the upper one, which is an exclusive edge already.
  wire [4:0] coarser = new_scale[4:0] - old_scale[4:0];
  wire [`CBVH_INDEX_BITS-1:0] kept = {`CBVH_INDEX_BITS{1'b1}} << coarser;
  wire rounds_up = |(old_to & ~kept);
  wire signed [`CBVH_INDEX_BITS-1:0] new_from = old_from >>> coarser;
  wire signed [`CBVH_INDEX_BITS-1:0] floor_to = old_to >>> coarser;
  wire [N-1:0] new_to = floor_to[N-1:0] + {{N - 1{1'b0}}, rounds_up};  // the rest of it matters to nobody
  wire [N-1:0] new_base = new_lower[N-1:0] & {N{relative}};
  assign new_lo = new_from[N-1:0] - new_base;
  assign new_hi = new_to - new_base;
  wire unused_high = &{new_lower[`CBVH_INDEX_BITS-1:N], floor_to[`CBVH_INDEX_BITS-1:N]};

  own_grid #(
      .N(N)
  ) own_before (
      .scale(old_scale),
      .lower(old_from),
      .cells(old_to[N-1:0] - old_from[N-1:0]),
      .min_scale(min_scale),
      .figure5(figure5),
      .own_scale(scale_before),
      .own_lower(lower_before)
  );
  own_grid #(
      .N(N)
  ) own_after (
      .scale(new_scale),
      .lower(new_from),
      .cells(new_to - new_from[N-1:0]),
      .min_scale(min_scale),
      .figure5(figure5),
      .own_scale(scale_after),
      .own_lower(lower_after)
  );
endmodule
