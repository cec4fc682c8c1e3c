// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The first reason to refuse an interval on a grid, or ok. Combinational. Twin of interval_status in
// rtl_model/datapath/axis_compress.h.
`include "cbvh_constants.vh"
module interval_status (
    input  wire signed [                 31:0] lower_key,
    input  wire signed [                 31:0] upper_key,
    input  wire signed [ `CBVH_SCALE_BITS-1:0] lower_place,
    input  wire signed [ `CBVH_SCALE_BITS-1:0] upper_place,
    input  wire                                lower_special,
    input  wire                                upper_special,
    input  wire signed [ `CBVH_SCALE_BITS-1:0] min_scale,
    output wire        [`CBVH_STATUS_BITS-1:0] status
);
  wire not_finite = lower_special | upper_special;
  wire inverted = upper_key < lower_key;
  wire inexact = (min_scale < lower_place) | (min_scale < upper_place);

  assign status = not_finite ? `CBVH_STATUS_NOT_FINITE :
                  inverted ? `CBVH_STATUS_INVERTED :
                  inexact ? `CBVH_STATUS_BEYOND_EXACTNESS : `CBVH_STATUS_OK;
endmodule
