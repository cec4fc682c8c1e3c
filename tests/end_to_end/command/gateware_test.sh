#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The Verilog twins: vectors under every stall mode. Twins that are broken on purpose: gateware_mutants_test.sh, lint:
# ../fpga/verilog_lint_test.sh.
source "$SOURCE/tests/end_to_end/command/expect.sh"
gateware=$SOURCE/fpga/gateware
command -v iverilog >/dev/null || { echo "skipped: no iverilog"; trap - EXIT; exit 77; }

# Vectors: all twins, all kinds of stalls; the same counts as the C++ modules.
twins=(axis_compressor scale_estimator node_pair_compressor node_pair_compressor_serial context_stack backtrack_unit
  treelet_collector stream_compressor box_decoder)
for unit in "${twins[@]}"; do
  expect 0 units "$unit"
  says out "gateware,golden,rtl"
  for stalls in none source sink both; do
    expect 0 check "$SOURCE/vectors/sets/$unit.vec" --backend gateware --stalls $stalls
    tail -n 1 out >gateware
    expect 0 check "$SOURCE/vectors/sets/$unit.vec" --backend rtl --stalls $stalls
    tail -n 1 out | cmp - gateware || fail "$unit --stalls $stalls: counts differ between gateware and rtl"
  done
  for n in 2 3 5 7 8; do
    [[ $unit == context_stack || $unit == treelet_collector || $unit == stream_compressor ]] && continue
    expect 0 gen --unit "$unit" --bits $n --cases 100 --seed $n -o n.bin
    expect 0 check n.bin --backend gateware --stalls both
  done
done
for levels in 1 3; do
  expect 0 gen --unit treelet_collector --bits $((2 + 2 * levels)) --treelet $levels --cases 21 --seed $levels -o d.bin
  expect 0 check d.bin --backend gateware --stalls both
done
expect 0 gen --unit stream_compressor --bits 8 --treelet 1 --cases 21 --seed 1 -o d.bin
expect 0 check d.bin --backend gateware --stalls both
expect 0 regress --backend gateware --unit axis_compressor --json report.json
json "j['failed'] == 0 and j['passed'] > 100000"
json "{s['backend'] for s in j['sets']} == {'gateware'} and {s['mode'] for s in j['sets']} == {'none', 'both'}"

expect 0 check "$SOURCE/vectors/sets/axis_compressor.vec" --backend gateware
says out "corners of the model: not observed by gateware, golden"
! grep -q 'warning: corner' out || fail "corners that nobody looked at are said to be missed"

# What the backend does not have is neither run nor passed.
expect 77 check "$SOURCE/vectors/sets/refit_unit.vec" --backend gateware
says err "backend gateware: has no unit 'refit_unit', only: axis_compressor"
[[ ! -s out ]] || fail "output although nothing was run"
expect 77 regress --backend gateware --unit axis_compressor --unit refit_unit
says err "has no unit 'refit_unit'"
refuses "no order of evaluation" check "$SOURCE/vectors/sets/axis_compressor.vec" --backend gateware --shuffle 1

# Verilog that does not compile is bad input, not a mismatch.
mkdir broken && cp "$gateware"/*.v "$gateware"/*.vh broken
sed -i 's/endmodule//' broken/skid_buffer.v
CBVH_GATEWARE=$PWD/broken expect 2 check "$SOURCE/vectors/sets/axis_compressor.vec" --backend gateware
