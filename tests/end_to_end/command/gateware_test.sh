#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The Verilog twins: constants, lint, vectors under every stall mode, and twins that were broken on purpose.
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
  if command -v yosys >/dev/null; then
    (cd "$gateware" && yosys -q -p "read_verilog -I. *.v harness/*.v; hierarchy -check -top $(basename "$file" .v); proc; check -assert") \
      >out 2>err || fail "yosys $file"
    grep -qi warning out err && fail "yosys $file has warnings"
    checks=$((checks + 1))
  fi
done
for tool in verilator yosys; do command -v $tool >/dev/null || echo "skipped: lint by $tool, which is not installed"; done

# Vectors: all twins, all kinds of stalls; the same counts as the C++ modules.
twins=(axis_compressor scale_estimator node_pair_compressor node_pair_compressor_serial context_stack backtrack_unit
  treelet_collector)
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
    [[ $unit == context_stack || $unit == treelet_collector ]] && continue
    expect 0 gen --unit "$unit" --bits $n --cases 400 --seed $n -o n.bin
    expect 0 check n.bin --backend gateware --stalls both
  done
done
for levels in 1 3; do
  expect 0 gen --unit treelet_collector --bits $((2 + 2 * levels)) --treelet $levels --cases 21 --seed $levels -o d.bin
  expect 0 check d.bin --backend gateware --stalls both
done
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

# mutant UNIT FILE SED: a twin with one line changed must fail its vectors.
mutant() {
  local unit=$1 file=$2 script=$3
  rm -rf broken && mkdir broken && cp "$gateware"/*.v "$gateware"/*.vh broken
  sed -i "$script" "broken/$file"
  [[ $(diff "$gateware/$file" "broken/$file" | grep -c '^>') == 1 ]] || fail "mutant $file '$script': not one line changed"
  CBVH_GATEWARE=$PWD/broken expect 1 check "$SOURCE/vectors/sets/$unit.vec" --backend gateware --stalls both
}
mutant axis_compressor axis_compressor.v 's/figure5_1 ? size + 1/~figure5_1 ? size + 1/'
mutant axis_compressor axis_compressor.v 's/upper_floor_1 + 26.sd1/upper_floor_1/'
mutant axis_compressor axis_compressor.v 's/      valid_2 <= valid_1/      valid_2 <= jobs_valid/'
mutant axis_compressor cell_floor.v 's/round_down = sign \&/round_down = 1'"'"'b0 \&/'
mutant axis_compressor interval_status.v 's/upper_key < lower_key/upper_key <= lower_key/'
mutant axis_compressor skid_buffer.v 's/out_data  = head ?/out_data  = ~head ?/'
mutant scale_estimator scale_estimator.v 's/LEAST_ZEROS\[5:0\] - /LEAST_ZEROS[5:0] - 6'"'"'d1 - /'
mutant scale_estimator scale_estimator.v 's/figure5_2     <= figure5_1/figure5_2     <= ~figure5_1/'
mutant scale_estimator scale_estimator.v 's/too_fine ? lower_cell >>> 1/too_fine ? lower_cell/'
mutant node_pair_compressor node_pair_compressor.v 's/context_5  <= context_4/context_5  <= context_3/'
mutant node_pair_compressor union_axis.v 's/order_key(left_upper) < /order_key(left_upper) > /'
mutant node_pair_compressor first_reason.v 's/reason < first/reason > first/'
mutant node_pair_compressor node_pair_compressor.v 's/relative_4 <= .*/relative_4 <= relative_5;/'
mutant context_stack context_stack.v 's/push \& ~underflow \& (kept == /push \& (depth == /'
mutant context_stack context_stack.v 's/second = depth\[4:0\] - 5.d2/second = depth[4:0] - 5'"'"'d1/'
mutant context_stack context_stack.v 's/depth <= depth_next/depth <= depth/'
mutant backtrack_unit backtrack_unit.v 's/next = repair_0 ? place_0/next = repair_1 ? place_1/'
mutant backtrack_unit backtrack_unit.v 's/    else if (repaired) repairs <= .*/    else if (repaired \& repair_0) repairs <= repairs + 1;/'
mutant backtrack_unit backtrack_unit.v 's/IDLE: if (jobs_valid) state <= requests_ready ? WRITE : READ;/IDLE: if (jobs_valid) state <= READ;/'
mutant backtrack_unit reencode_axis.v 's/full = ~(|s)/full = 1'"'"'b0/'
mutant backtrack_unit reencode_axis.v 's/rounds_up = |(old_to/rounds_up = |(old_from/'
mutant backtrack_unit own_grid.v 's/figure5 ? cells : cells - /figure5 ? cells - 1'"'"'b1 : cells - /'
mutant backtrack_unit context_changed.v 's/relative \& lower/lower/'
mutant treelet_collector treelet_assembler.v 's/left = \&inner ? entries\[second\]/left = \&inner ? entries[top]/'
mutant treelet_collector treelet_row.v 's/refused <= root ? .*/refused <= tree_status;/'
mutant treelet_collector treelet_levels.v 's/reason = above/reason = `CBVH_STATUS_OK/'
mutant treelet_collector final_queue.v 's/beyond_tail\[D\]}/1'"'"'b0}/'

# Verilog that does not compile is bad input, not a mismatch.
sed -i 's/endmodule//' broken/skid_buffer.v
CBVH_GATEWARE=$PWD/broken expect 2 check "$SOURCE/vectors/sets/axis_compressor.vec" --backend gateware
