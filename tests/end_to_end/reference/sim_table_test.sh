#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# `cbvh sim` leaves the tree of every row of table.txt in the simulated DRAM, in every configuration that writes one, undisturbed and with
# stalls at the ports and jitter of the DRAM. Rows of files need the folder $CBVH_SCENES; without it they are said to be skipped.
set -euo pipefail
passed=0
failed=0
skipped=0

# expect NAME FOUND WANTED
expect() {
  if [[ $2 == "$3" ]]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED $what: $1 is $2, want $3"
  fi
}
# field KEY: of the JSON in result.json.
field() { tr -d ' \n' <result.json | sed -n 's/.*"'"$1"'":\("[^"]*"\|[^,}]*\).*/\1/p' | tr -d '"'; }

while read -r scene rule triangles leaves pairs e_min root digest relative modulo; do
  [[ $scene == \#* || $scene == independent || $rule != equation2 ]] && continue
  file=$scene
  if [[ $scene != proc:* ]]; then
    file=${CBVH_SCENES:-/nowhere}/$scene
    [[ -e $file ]] || { skipped=$((skipped + 1)); continue; }
  fi
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
done <"$SOURCE/tests/end_to_end/reference/table.txt"
((skipped == 0)) || echo "skipped: $skipped rows, their scenes are not in CBVH_SCENES"
echo "$passed passed, $failed failed"
((failed == 0 && passed > 0))
