#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# `cbvh sim` leaves the tree of every row of table.txt in the simulated DRAM, in every configuration that writes one, undisturbed and with
# stalls at the ports and jitter of the DRAM.
set -euo pipefail
source "$SOURCE/tests/end_to_end/reference/rows.sh"

check_row() {
  [[ $rule == equation2 ]] || return 0
  for config in float-top-down:0 "streaming-relative:${relative%%,*}" "streaming-modulo:${modulo##*,}"; do
    for disturbance in "" "--stalls 1" "--set dram.jitter=80" "--stalls 2 --set dram.jitter=80"; do
      what="$scene ${config%:*} $disturbance"
      # shellcheck disable=SC2086
      "$CBVH" sim "$file" --config "${config%:*}" --no-utilisation $disturbance --json result.json >/dev/null
      expect triangles "$(field triangles)" "$triangles"
      expect leaves "$(field leaves)" "$leaves"
      expect pairs "$(field pairs)" "$pairs"
      expect e_min "$(field e_min)" "$e_min"
      expect digest "$(field digest)" "$digest"
      expect identical "$(field identical)" true
      expect hardware_backtracks "$(field hardware_backtracks)" "${config#*:}"
      expect pass "$(field pass)" true
    done
  done
}
for_each_row check_row
