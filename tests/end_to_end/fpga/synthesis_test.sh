#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# scripts/fpga: usage, the area of every twin, bitstreams whose clock is reached; and gateware that does not synthesize, fit or reach it.
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
for wrong in "" "no_such_command" "synth no_such_unit" "synth --family no_such_family" "hx8k --bits 9" "synth --depth 9" "hx8k --unit no_such_unit"; do
  command -v yosys >/dev/null || [[ ! $wrong =~ unit|family ]] || continue
  [[ $wrong != *--unit* ]] || command -v nextpnr-ice40 >/dev/null || continue
  # shellcheck disable=SC2086
  runs 2 $wrong
done
command -v yosys >/dev/null || { echo "skipped: no yosys"; exit 77; }
# Every twin, in small: all of their files go through technology mapping. A stack or a queue is block RAM.
runs 0 synth --family ice40 --bits 4 --depth 1
# area UNIT LUTS REGISTERS MEMORIES: at least so many
area() {
  awk -F'|' -v unit=" $1 " "\$2 == unit { found = \$3 >= $2 && \$4 >= $3 && \$5 >= $4 && \$6 > 0.2 && \$6 < 100 } END { exit !found }" out ||
    fail "$1: no plausible area"
  checks=$((checks + 1))
}
area binary32_adder 400 100 0
area axis_compressor 800 150 0
area scale_estimator 500 100 0
area node_pair_compressor 5000 1000 0
area node_pair_compressor_serial 2000 800 0
area context_stack 100 50 14
area backtrack_unit 2000 300 10
area treelet_collector 5000 1000 50
area stream_compressor 10000 2000 60
area box_decoder 2000 500 0
(($(grep -c '^|' out) == 12)) || fail "want ten rows below two of a header"

# A copy of the tree with one file broken. broken FILE SED: exactly one line of fpga/FILE differs.
broken() {
  rm -rf root && mkdir root && cp -r "$SOURCE/scripts" "$SOURCE/fpga" root
  sed -i "$2" "root/fpga/$1"
  [[ $(diff "$SOURCE/fpga/$1" "root/fpga/$1" | grep -c '^<') == 1 ]] || fail "$1 '$2': not one line changed"
}
# broken_runs PATTERN ARGUMENT...: exit code 1, and the pattern among the errors
broken_runs() {
  local pattern=$1 found=0
  shift
  bash root/scripts/fpga "$@" >out 2>err </dev/null || found=$?
  ((found == 1)) || fail "broken gateware, scripts/fpga $*: exit code $found, want 1"
  grep -qE "$pattern" err || fail "broken gateware, scripts/fpga $*: no '$pattern' on stderr"
  checks=$((checks + 1))
}
broken gateware/cell_floor.v 's/^endmodule//'
broken_runs 'syntax error' synth --family ice40 scale_estimator
broken gateware/cell_floor.v 's/^module cell_floor /module cell_ceiling /'
broken_runs 'cell_floor.*is not part of the design' synth --family ice40 scale_estimator
broken gateware/final_queue.v "s/^        entry = {WIDTH{1'b0}};//"
broken_runs 'dlatch' synth --family ice40 treelet_collector
broken gateware/skid_buffer.v 's/^  assign in_ready  = ~full;/  assign in_ready = ~full; assign in_ready = occupied;/'
broken_runs 'ERROR: Found [0-9]+ problems' synth --family ice40 node_pair_compressor_serial
broken gateware/context_stack.v 's/^  wire \[5:0\] kept = .*/  wire [5:0] kept = depth_next;/'
broken_runs 'ERROR: Found [0-9]+ problems' synth --family ice40 context_stack

command -v nextpnr-ice40 >/dev/null && command -v icepack >/dev/null || { echo "skipped: no nextpnr-ice40 or icepack"; exit 77; }
# board NAME UNIT BYTES: a bitstream of at least so many bytes, and less than the whole device
board() {
  runs 0 "$1" --unit "$2" -o "$PWD/board"
  [[ $(stat -c %s board/top.bin) -gt $3 ]] || fail "$1: no bitstream"
  awk '$1 == "ICESTORM_LC" { found = $2 > 3000 && $2 <= $4 + 0 } END { exit !found }' out || fail "$1: no utilisation"
  (($(grep -c 'fmax of the' out) == 2)) || fail "$1: no fmax"
  rm -r board
}
board hx8k axis_compressor 100000
board up5k scale_estimator 100000
broken gateware/engine/frame_sender.v 's/^module frame_sender /module frame_sender_ /'
broken_runs 'frame_sender.*is not part of the design' hx8k -o "$PWD/board"
# What does not fit is no bitstream, nor is a clock that cannot be reached.
runs 1 up5k --unit node_pair_compressor_serial -o "$PWD/small"
grep -qE 'does not fit: [0-9]+ of 5280 ICESTORM_LC$' err || fail "the excess is not told"
[[ ! -e small/top.bin ]] || fail "a bitstream of what does not fit"
broken gateware/README.md '1s/$/ /'
sed 's/clock_mhz=24$/clock_mhz=200/' "$SOURCE/scripts/fpga" >root/scripts/fpga
grep -q clock_mhz=200 root/scripts/fpga || fail "the clock is not where it was"
broken_runs 'the clock is not reached' hx8k --unit scale_estimator -o "$PWD/hasty"
echo "$checks checks"
