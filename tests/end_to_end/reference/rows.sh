# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# Sourced by the tests of the reference results: the rows of table.txt, and checks that count.
passed=0
failed=0
skipped=0

# expect NAME FOUND WANTED: of what $what names.
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
  tr -d ' \n' <result.json | sed -n 's/.*"'"$1"'":\(\[[^]]*\]\|"[^"]*"\|[^,}]*\).*/\1/p' | tr -d '[]"'
}
# for_each_row COMMAND: with scene rule triangles leaves pairs e_min root digest relative modulo set, and $file what the scene is called. Rows of
# files need the folder $CBVH_SCENES; without it they are said to be skipped.
for_each_row() {
  while read -r scene rule triangles leaves pairs e_min root digest relative modulo; do
    [[ $scene == \#* || $scene == independent ]] && continue
    file=$scene
    if [[ $scene != proc:* ]]; then
      file=${CBVH_SCENES:-/nowhere}/$scene
      [[ -e $file ]] || { skipped=$((skipped + 1)); continue; }
    fi
    "$1"
  done <"$SOURCE/tests/end_to_end/reference/table.txt"
  ((skipped == 0)) || echo "skipped: $skipped rows, their scenes are not in CBVH_SCENES"
  echo "$passed passed, $failed failed"
  ((failed == 0 && passed > 0))
}
