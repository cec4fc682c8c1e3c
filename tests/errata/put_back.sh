#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# Puts each printed form of the paper that is wrong (docs/arithmetic.md) back into a copy of the sources, builds the test that pins it, and
# demands that this test fails. A form that no longer applies, or a test that still passes, fails the script.
# Environment: SOURCE, the repository's root; CXX and CMAKE; runs in an empty scratch folder.
set -euo pipefail

cmake=${CMAKE:-cmake}
mkdir copy
(cd "$SOURCE" && tar cf - CMakeLists.txt cmake golden rtl_model vectors testbench fpga tests bench) | tar xf - -C copy
"$cmake" -S copy -B build -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="${CXX:-c++}" -DCBVH_BUILD_BENCH=OFF > configure.log
unit=hardware_errata_test
"$cmake" --build build --target $unit > build.log 2>&1 || { tail -n 30 build.log; exit 1; }
program=$(find build -name $unit -type f -perm -u+x)
"$program" > /dev/null || { echo "$unit fails before anything is put back"; exit 1; }

passed=0
failed=0

# put_back FILE FROM TO TEST: FROM is a fixed string of the file, once a line.
put_back() {
  local file=copy/$1 from=$2 to=$3 name=$4
  cp "$file" original
  FROM=$from TO=$to perl -0pi -e 's/\Q$ENV{FROM}\E/$ENV{TO}/ or exit 3' "$file" || true
  if cmp -s original "$file"; then
    echo "FAILED  $name: '$from' is no longer in $1"
    failed=$((failed + 1))
    return
  fi
  if ! "$cmake" --build build --target $unit > build.log 2>&1; then
    echo "FAILED  $name: the printed form does not build"
    tail -n 5 build.log
    failed=$((failed + 1))
  elif "$program" --gtest_filter="HardwareErrata.$name" > run.log 2>&1; then
    echo "FAILED  $name passes with the printed form in $1"
    failed=$((failed + 1))
  else
    echo "caught  $name"
    passed=$((passed + 1))
  fi
  cp original "$file"
  touch "$file"
}

put_back rtl_model/datapath/codes.h '~any(s)' '~differ(lo, hi)' full_span_is_told_by_the_span_alone
put_back rtl_model/datapath/cell_index.h 'select(figure5, cells, difference)' 'select(figure5, cells, cells)' \
  a_size_that_is_a_power_of_two_fills_the_finer_grid
put_back rtl_model/datapath/cell_index.h 'truncated - round_down' 'truncated - (round_down & ~round_down)' \
  alignment_of_a_negative_number_rounds_towards_minus_infinity
put_back rtl_model/datapath/float_fields.h 'const auto sign = negative(index);' 'const auto sign = negative(index) & ~negative(index);' \
  a_negative_edge_is_packed_as_sign_and_magnitude
put_back rtl_model/datapath/axis_compress.h 'pack_float<Bits>(upper_index, scale)' 'pack_float<Bits>(lower_index, scale)' \
  the_upper_edge_is_packed_from_the_upper_index
put_back rtl_model/datapath/codes.h 'shift_right(cells.upper, coarser) + rounds_up' \
  'shift_right(cells.upper, coarser) + (rounds_up | constant<Bits, 1>(1))' re_encoding_takes_the_ceiling_of_an_upper_edge
put_back rtl_model/datapath/scale_estimate.h 'fine + too_fine' 'fine + (too_fine & ~too_fine)' \
  an_estimate_fits_where_the_exponent_of_the_size_alone_does_not
put_back rtl_model/datapath/codes.h 'relative & moved & ~scale' 'relative & moved & scale' relative_codes_need_the_lower_index_compared_too
put_back rtl_model/datapath/pair_compress.h 'job.pair.box[child].upper[axis]' 'job.pair.box[1].upper[axis]' \
  each_child_is_compressed_from_its_own_box
put_back rtl_model/compress/treelet_collector.h '{!job.pair.leaf[0], !job.pair.leaf[1]}' '{bool(job.pair.leaf[0]), bool(job.pair.leaf[1])}' \
  contexts_are_taken_off_the_stack_for_inner_children_only
put_back rtl_model/compress/lazy_treelet_collector.h '{!job.pair.leaf[0], !job.pair.leaf[1]}' '{bool(job.pair.leaf[0]), bool(job.pair.leaf[1])}' \
  contexts_are_taken_off_the_stack_for_inner_children_only
put_back rtl_model/compress/treelet.h 'std::size_t{1} << levels;' 'static_cast<std::size_t>(levels * levels);' \
  a_treelet_of_m_levels_holds_two_to_the_m_minus_one_pairs
put_back rtl_model/datapath/axis_compress.h 'select(inexact, status_of(Status::beyond_exactness), status_of(Status::ok))' \
  'select(inexact, status_of(Status::ok), status_of(Status::ok))' \
  a_minimum_scale_finer_than_a_last_place_is_refused

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
