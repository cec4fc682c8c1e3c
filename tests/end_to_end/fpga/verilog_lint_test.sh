#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# TOOL, one of iverilog, verilator, yosys, has no warning about the Verilog: the twins, the frame engine, the boards.
gateware=$SOURCE/fpga/gateware
boards=$SOURCE/fpga/boards
command -v "$TOOL" >/dev/null || { echo "skipped: no $TOOL"; exit 77; }

checks=0
# silent WHAT COMMAND...: succeeds and says nothing that is a warning.
silent() {
  local what=$1
  shift
  "$@" >out 2>err || { cat out err; echo "FAILED: $TOOL $what"; exit 1; }
  if [[ $TOOL == yosys ]]; then ! grep -qi warning out err; else [[ ! -s err ]]; fi || { cat err; echo "FAILED: $TOOL $what has warnings"; exit 1; }
  checks=$((checks + 1))
}
# lint WHAT OPTION...: by iverilog or verilator. Parameters are given as iverilog wants them, -PMODULE.NAME=VALUE.
lint() {
  local what=$1
  shift
  if [[ $TOOL == iverilog ]]; then
    silent "$what" iverilog -Wall -g2005 -t null "$@"
  else
    silent "$what" verilator --lint-only -Wall "${@/#-P*./-G}"
  fi
}

if [[ $TOOL == yosys ]]; then
  silent "twins" yosys -q -p "read_verilog -I$gateware $gateware/*.v $gateware/harness/*.v; hierarchy -check; proc; check -assert"
  silent "board" yosys -q -p "read_verilog -DCBVH_UNIT_AXIS_COMPRESSOR -I$gateware -I$gateware/engine $gateware/*.v $gateware/engine/*.v $boards/common/*.v
    hierarchy -check -top uart_board; proc; check -assert"
else
  # Every file of the twins by itself, for the smallest and the largest N, and for treelets of one and of three levels.
  for file in "$gateware"/*.v "$gateware"/harness/*.v; do
    for n in 2 8; do
      parameters=()
      if grep -q 'parameter N ' "$file"; then parameters=("-P$(basename "$file" .v).N=$n"); fi
      if grep -q 'parameter D ' "$file"; then parameters+=("-P$(basename "$file" .v).D=$((n == 2 ? 1 : 3))"); fi
      lint "$(basename "$file") N=$n" "${parameters[@]}" -y "$gateware" -y "$gateware/harness" "-I$gateware" "$file"
    done
  done
  # The board as a whole, with units with and without state, with and without N (in responses, in stimuli), one batch buffer and two.
  for unit in AXIS_COMPRESSOR CONTEXT_STACK BOX_DECODER; do
    for buffers in 1 2; do
      top=(-s uart_board)
      if [[ $TOOL == verilator ]]; then top=(--top-module uart_board); fi
      lint "board, $unit, $buffers buffers" -DCBVH_UNIT_$unit -Puart_board.BUFFERS=$buffers "${top[@]}" -y "$gateware" -y "$gateware/engine" \
        -y "$boards/common" "-I$gateware" "-I$gateware/engine" "$boards/common/uart_board.v"
    done
  done
fi
((checks > 0))
echo "$checks checks"
