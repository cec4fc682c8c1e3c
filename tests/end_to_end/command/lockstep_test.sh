#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# Verilog twins beside their C++ modules, cycle by cycle. CYCLES: of each twin under each pattern of stalls.
source "$SOURCE/tests/end_to_end/command/expect.sh"

refuses "found 'foo', want axis_compressor" lockstep foo
status=0
PATH=/nowhere "$CBVH" lockstep >out 2>err || status=$?
((status == 77)) || fail "without iverilog: exit code $status, want 77"
[[ ! -s out && $(wc -l <err) == 1 ]] || fail "without iverilog: one line on stderr and no output"
says err "no program 'iverilog' (Debian package iverilog)"
command -v iverilog >/dev/null || { echo "skipped: no iverilog"; trap - EXIT; exit 77; }

expect 0 lockstep --cycles "$CYCLES" --json report.json
json "j['failed'] == 0 and j['passed'] == len(j['results']) == 4 * len({r['twin'] for r in j['results']})"
json "{r['stalls'] for r in j['results']} == {'none', 'source', 'sink', 'both'}"
json "all(r['cycles'] >= $CYCLES and r['moves'] > 0 and r['signals'] >= 10 * r['cycles'] for r in j['results'])"
json "{'axis_compressor', 'scale_estimator', 'node_pair_compressor', 'node_pair_compressor_serial', 'context_stack', 'box_decoder', 'skid_buffer'} <= {r['twin'] for r in j['results']}"

# It can fail: a difference names unit, cycle, signal and both values.
# differs TWIN FILE SED PATTERN
differs() {
  rm -rf broken && mkdir broken && cp "$SOURCE"/fpga/gateware/*.v "$SOURCE"/fpga/gateware/*.vh broken
  sed -i "$3" "broken/$2"
  cmp -s "$SOURCE/fpga/gateware/$2" "broken/$2" && fail "$2: not changed by $3"
  CBVH_GATEWARE=$PWD/broken expect 1 lockstep "$1" --cycles 300
  grep -qE "^  $1 bits=[0-9] treelet=1 stalls=[a-z]+ seed=[0-9]+: episode [0-9]+ cycle [0-9]+: $4$" out || fail "no line: $4"
}
differs axis_compressor axis_compressor.v 's/upper_floor_1 + 26.sd1/upper_floor_1/' 'results\.pushed: C\+\+ [0-9a-f]+, Verilog [0-9a-f]+'
differs axis_compressor axis_compressor.v 's/assign jobs_ready = results_ready/assign jobs_ready = 1/' 'jobs\.(ready|pop): C\+\+ 0, Verilog 1'
differs scale_estimator scale_estimator.v 's/      valid_2 <= valid_1/      valid_2 <= jobs_valid/' 'results\.(push|valid): C\+\+ 0, Verilog 1'
differs box_decoder decode_codes.v 's/full = ~(|s)/full = hi == lo/' 'results\.pushed: C\+\+ [0-9a-f]+, Verilog [0-9a-f]+'
differs skid_buffer skid_buffer.v 's/(~full) newer/(~occupied) newer/' 'out\.data: C\+\+ [0-9a-f]+, Verilog [0-9a-fx]+'
differs context_stack stack_memory.v 's/5.d2/5'"'"'d1/' 'replies\.pushed: C\+\+ [0-9a-f]+, Verilog [0-9a-f]+'
