#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The Verilog twins: constants, lint, vectors under every stall mode. Twins that are broken on purpose: gateware_mutants_test.sh.
source "$SOURCE/tests/end_to_end/command/expect.sh"
gateware=$SOURCE/fpga/gateware

expect 0 gateware
cmp out "$gateware/cbvh_constants.vh" || fail "fpga/gateware/cbvh_constants.vh is not what 'cbvh gateware' writes"

# Where there is no Icarus the backend says so in one line, and nothing is reported as passed.
status=0
PATH=/nowhere "$CBVH" check "$SOURCE/vectors/sets/axis_compressor.vec" --backend gateware >out 2>err || status=$?
((status == 77)) || fail "without iverilog: exit code $status, want 77"
[[ ! -s out && $(wc -l <err) == 1 ]] || fail "without iverilog: one line on stderr and no output"
says err "no program 'iverilog' (Debian package iverilog)"
command -v iverilog >/dev/null || { echo "skipped: no iverilog"; trap - EXIT; exit 77; }

# Lint: every file by itself, for the smallest and the largest N, and for treelets of one and of three levels.
for file in "$gateware"/*.v "$gateware"/harness/*.v; do
  for n in 2 8; do
    parameter=()
    if grep -q 'parameter N ' "$file"; then parameter=("-P$(basename "$file" .v).N=$n"); fi
    if grep -q 'parameter D ' "$file"; then parameter+=("-P$(basename "$file" .v).D=$((n == 2 ? 1 : 3))"); fi
    iverilog -Wall -g2005 -t null "${parameter[@]}" -y "$gateware" -y "$gateware/harness" -I "$gateware" "$file" \
      >out 2>err || fail "iverilog $file"
    [[ ! -s out && ! -s err ]] || fail "iverilog -Wall $file has warnings"
    if command -v verilator >/dev/null; then
      verilator --lint-only -Wall "${parameter[@]/#-P*./-G}" -y "$gateware" -y "$gateware/harness" "-I$gateware" "$file" \
        >out 2>err || fail "verilator $file"
      [[ ! -s err ]] || fail "verilator -Wall $file has warnings"
    fi
    checks=$((checks + 1))
  done
done
if command -v yosys >/dev/null; then
  (cd "$gateware" && yosys -q -p "read_verilog -I. *.v harness/*.v; hierarchy -check; proc; check -assert") >out 2>err || fail yosys
  ! grep -qi warning out err || fail "yosys has warnings"
  checks=$((checks + 1))
fi
for tool in verilator yosys; do command -v $tool >/dev/null || echo "skipped: lint by $tool, which is not installed"; done

# Vectors: all twins, all kinds of stalls; the same counts as the C++ modules.
twins=(axis_compressor scale_estimator node_pair_compressor node_pair_compressor_serial context_stack backtrack_unit
  treelet_collector stream_compressor)
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
