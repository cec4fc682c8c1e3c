// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Inside a module with the parameter D. Twin of pre_order in rtl_model/compress/treelet.h.
// The position of the n-th pair, in depth-first pre-order, of a whole treelet of D - 1 levels.
function integer pre_order(input integer n);
  integer left_to_go, size, step;
  begin
    pre_order  = 1;
    left_to_go = n;
    size       = (1 << (D - 1)) - 1;
    for (step = 0; step < D; step = step + 1) begin
      if (left_to_go > 0) begin
        size       = (size - 1) / 2;
        pre_order  = 2 * pre_order + (left_to_go > size ? 1 : 0);
        left_to_go = left_to_go > size ? left_to_go - 1 - size : left_to_go - 1;
      end
    end
  end
endfunction
