#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# scripts/fpga: usage, an area table, and a bitstream whose clock is reached.
set -euo pipefail
checks=0
fail() { echo "FAILED: $1"; cat out err; exit 1; }
# runs EXIT_CODE ARGUMENT...
runs() {
  local want=$1 found=0
  shift
  "$SOURCE/scripts/fpga" "$@" >out 2>err </dev/null || found=$?
  ((found == want)) || fail "scripts/fpga $*: exit code $found, want $want"
  checks=$((checks + 1))
}
runs 0 --help
for wrong in "" "no_such_command" "synth no_such_unit" "synth --family no_such_family" "hx8k --bits 9" "hx8k --unit no_such_unit"; do
  command -v yosys >/dev/null || [[ ! $wrong =~ unit|family ]] || continue
  [[ $wrong != *--unit* ]] || command -v nextpnr-ice40 >/dev/null || continue
  # shellcheck disable=SC2086
  runs 2 $wrong
done
command -v yosys >/dev/null || { echo "skipped: no yosys"; exit 77; }
runs 0 synth --family ice40 scale_estimator
[[ $(awk -F'|' '/scale_estimator/ { print ($3 > 300 && $4 > 100 && $6 > 1 && $6 < 4) }' out) == 1 ]] || fail "no plausible area"
command -v nextpnr-ice40 >/dev/null && command -v icepack >/dev/null || { echo "skipped: no nextpnr-ice40 or icepack"; exit 77; }
runs 0 hx8k --unit scale_estimator -o "$PWD/board"
[[ $(stat -c %s board/top.bin) -gt 100000 ]] || fail "no bitstream"
grep -q 'ICESTORM_LC' out || fail "no utilisation"
# A clock that cannot be reached is a failure, not a bitstream to be flashed.
sed 's/clock_mhz=24$/clock_mhz=200/' "$SOURCE/scripts/fpga" >hasty
grep -q clock_mhz=200 hasty || fail "the clock is not where it was"
mkdir -p root/scripts && cp hasty root/scripts/fpga && ln -s "$SOURCE/fpga" root/fpga
found=0
bash root/scripts/fpga hx8k --unit scale_estimator -o "$PWD/hasty_board" >out 2>err || found=$?
((found == 1)) && grep -q 'the clock is not reached' err || fail "200 MHz: exit code $found"
echo "$((checks + 2)) checks"
