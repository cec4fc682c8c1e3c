#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# `cbvh build` gives the reference results for every row of table.txt, both codes, D = 1..4 and both collectors, streamed by the C++ modules.
# Rows of files need the folder $CBVH_SCENES; without it they are said to be skipped. $REFERENCE_SCENES may name other scenes to check.
set -euo pipefail
here=$SOURCE/tests/end_to_end/reference
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
# field KEY: of the JSON in result.json, lists without brackets.
field() {
  tr -d ' \n' < result.json | sed -n 's/.*"'"$1"'":\(\[[^]]*\]\|"[^"]*"\|[^,}]*\).*/\1/p' | tr -d '[]"'
}

while read -r scene rule triangles leaves pairs e_min root digest relative modulo; do
  [[ $scene == \#* || $scene == independent ]] && continue
  file=$scene
  if [[ $scene != proc:* ]]; then
    file=${CBVH_SCENES:-/nowhere}/$scene
    [[ -e $file ]] || { skipped=$((skipped + 1)); continue; }
  fi
  for code in relative modulo; do
    IFS=, read -r -a backtracks <<< "${!code}"
    for levels in 1 2 3 4; do
      for collector in full lazy; do
        what="$scene $rule $code D=$levels $collector"
        "$CBVH" build "$file" --code $code --treelet $levels --scale-rule "$rule" --collector $collector --json result.json > /dev/null
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
done < "$here/table.txt"
((skipped == 0)) || echo "skipped: $skipped rows, their scenes are not in CBVH_SCENES"
echo "$passed passed, $failed failed"
((failed == 0 && passed > 0))
