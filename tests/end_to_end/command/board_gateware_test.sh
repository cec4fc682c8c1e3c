#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The board's gateware: its constants, and lint of the frame engine and of the boards. What it does: tests/unit/fpga_emulator/.
source "$SOURCE/tests/end_to_end/command/expect.sh"
gateware=$SOURCE/fpga/gateware
boards=$SOURCE/fpga/boards

expect 0 gateware --board
cmp out "$gateware/engine/cbvh_board.vh" || fail "fpga/gateware/engine/cbvh_board.vh is not what 'cbvh gateware --board' writes"
grep -q CBVH_UNIT_AXIS_COMPRESSOR out || fail "no unit"
command -v iverilog >/dev/null || { echo "skipped: no iverilog"; trap - EXIT; exit 77; }

# As a whole, with units with and without state, with and without N, one batch buffer and two.
paths=(-y "$gateware" -y "$gateware/engine" -y "$boards/common")
for unit in AXIS_COMPRESSOR CONTEXT_STACK; do
  for buffers in 1 2; do
    iverilog -Wall -g2005 -t null -DCBVH_UNIT_$unit -Puart_board.BUFFERS=$buffers -s uart_board "${paths[@]}" -I "$gateware" \
      -I "$gateware/engine" "$boards/common/uart_board.v" >out 2>err || fail "iverilog $unit"
    [[ ! -s out && ! -s err ]] || fail "iverilog -Wall $unit has warnings"
    checks=$((checks + 1))
    command -v verilator >/dev/null || continue
    verilator --lint-only -Wall -DCBVH_UNIT_$unit -GBUFFERS=$buffers "${paths[@]}" "-I$gateware" "-I$gateware/engine" \
      "$boards/common/uart_board.v" >out 2>err || fail "verilator $unit"
    [[ ! -s err ]] || fail "verilator -Wall $unit has warnings"
  done
done
if command -v yosys >/dev/null; then
  yosys -q -p "read_verilog -DCBVH_UNIT_AXIS_COMPRESSOR -I$gateware -I$gateware/engine $gateware/*.v $gateware/engine/*.v $boards/common/*.v
    hierarchy -check -top uart_board; proc; check -assert" >out 2>err || fail yosys
  ! grep -qi warning out err || fail "yosys has warnings"
  checks=$((checks + 1))
fi
for tool in verilator yosys; do command -v $tool >/dev/null || echo "skipped: lint by $tool, which is not installed"; done
