# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# Sourced by the command tests. Every check counts; a test that checked nothing fails.
checks=0
finish() { ((checks > 0)) || { echo "no checks"; exit 1; }; echo "$checks checks"; }
trap 'status=$?; ((status == 0)) && finish || exit $status' EXIT

fail() { echo "FAILED: $1"; echo "--- stdout"; cat out; echo "--- stderr"; cat err; exit 1; }

# expect EXIT_CODE ARGUMENT...: runs cbvh; its output is in the files out and err.
expect() {
  local want=$1 found=0
  shift
  "$CBVH" "$@" >out 2>err </dev/null || found=$?
  ((found == want)) || fail "cbvh $*: exit code $found, want $want"
  checks=$((checks + 1))
}
# says FILE TEXT: the file has a line with this text.
says() { grep -qF -- "$2" "$1" || fail "$1 lacks: $2"; checks=$((checks + 1)); }
# refuses TEXT ARGUMENT...: exit code 2, nothing on stdout, and one line on stderr, `cbvh: place: what`, with the text.
refuses() {
  local text=$1
  shift
  expect 2 "$@"
  [[ ! -s out ]] || fail "cbvh $*: output although it refuses"
  [[ $(wc -l <err) == 1 ]] || fail "cbvh $*: more than one line of error"
  grep -qE '^cbvh: [^ ]+( [^ ]+)?: .' err || fail "cbvh $*: not 'cbvh: place: what'"
  says err "$text"
}
# json EXPRESSION: evaluates to true in python, with the JSON of the file report.json as `j`.
json() {
  python3 -c "import json,sys; j = json.load(open('report.json')); sys.exit(not ($1))" || { cat report.json; fail "JSON: $1"; }
  checks=$((checks + 1))
}
