#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The constants that the Verilog shares with C++, and what is said where there is no Icarus.
source "$SOURCE/tests/end_to_end/command/expect.sh"
gateware=$SOURCE/fpga/gateware

expect 0 gateware
cmp out "$gateware/cbvh_constants.vh" || fail "fpga/gateware/cbvh_constants.vh is not what 'cbvh gateware' writes"
expect 0 gateware --board
cmp out "$gateware/engine/cbvh_board.vh" || fail "fpga/gateware/engine/cbvh_board.vh is not what 'cbvh gateware --board' writes"
grep -q CBVH_UNIT_AXIS_COMPRESSOR out || fail "no unit"

# Where there is no Icarus the backend says so in one line, and nothing is reported as passed.
status=0
PATH=/nowhere "$CBVH" check "$SOURCE/vectors/sets/axis_compressor.vec" --backend gateware >out 2>err || status=$?
((status == 77)) || fail "without iverilog: exit code $status, want 77"
[[ ! -s out && $(wc -l <err) == 1 ]] || fail "without iverilog: one line on stderr and no output"
says err "no program 'iverilog' (Debian package iverilog)"
