#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# `cbvh build` gives the reference results for every row of table.txt, both codes, D = 1..4 and both collectors, streamed by the C++ modules.
set -euo pipefail
source "$SOURCE/tests/end_to_end/reference/rows.sh"

check_row() {
  for code in relative modulo; do
    IFS=, read -r -a backtracks <<<"${!code}"
    for levels in 1 2 3 4; do
      for collector in full lazy; do
        what="$scene $rule $code D=$levels $collector"
        "$CBVH" build "$file" --code $code --treelet $levels --scale-rule "$rule" --collector $collector --json result.json >/dev/null
        expect triangles "$(field triangles)" "$triangles"
        expect leaves "$(field leaves)" "$leaves"
        expect pairs "$(field pairs)" "$pairs"
        expect e_min "$(field e_min)" "$e_min"
        [[ $root == - ]] || expect root_exponents "$(field root_exponents)" "$root"
        expect digest "$(field digest)" "$digest"
        expect topdown_digest "$(field topdown_digest)" "$digest"
        expect identical "$(field identical)" true
        expect streamed_by "$(field streamed_by)" rtl
        expect backtracks "$(field backtracks)" "${backtracks[levels - 1]}"
        expect hardware_backtracks "$(field hardware_backtracks)" "${backtracks[levels - 1]}"
        expect violations "$(field violations)" 0
      done
    done
  done
}
for_each_row check_row
