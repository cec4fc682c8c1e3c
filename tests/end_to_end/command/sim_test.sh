#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# sim and refit: what they print and write, and what they refuse.
source "$SOURCE/tests/end_to_end/command/expect.sh"

small="proc:soup,triangles=2000"
# Every configuration leaves the golden's tree.
for config in float float-top-down streaming-relative streaming-modulo; do
  expect 0 sim "$small" --config $config --json report.json
  says out "memory holds the golden's tree, bit for bit"
  json "j['pass'] and j['identical'] and all(row['exact'] for row in j['traffic'])"
  json "j['milliseconds'] * 1e6 == j['cycles'] and j['over_bandwidth_bound'] > 1"
  json "all(sum(use.values()) == j['cycles'] for use in j['utilisation'].values())"
  json "j['config']['scratchpad_bytes'] == '262144'"
done
expect 0 sim "$small" --json report.json -o tree.cbvh
json "j['digest'] == j['golden_digest'] and j['backtracks'] == j['hardware_backtracks']"
expect 0 validate tree.cbvh --scene "$small"
# The same bits whatever the memory and the order do; stalls cost cycles.
digest=$(python3 -c "import json; print(json.load(open('report.json'))['digest'])")
for disturbance in "--stalls 3" "--shuffle 5" "--set memory=ideal" "--set dram.channels=1" "--set dram.jitter=50" "--set scratchpad_bytes=1024"; do
  # shellcheck disable=SC2086
  expect 0 sim "$small" $disturbance --no-utilisation --json report.json
  json "j['pass'] and j['digest'] == '$digest'"
done

# Configurations from a file; the table of values.
echo '{"treelet": 2, "code": "relative", "dram.channels": 4}' >config.json
expect 0 sim "$small" --config config.json --json report.json
json "j['config']['treelet'] == '2' and j['config']['dram.channels'] == '4' and j['output'] == 'streaming relative D=2 full'"
expect 0 sim --list-config --config config.json
says out "dram.row_bytes"

# Waveforms of one module and some cycles; a trace that Ramulator reads, one line an access.
expect 0 sim "$small" --vcd wave.vcd --scope run_merger --cycles 4000:4100
says wave.vcd '$scope module run_merger $end'
python3 - <<'PYTHON' || fail "wave.vcd: cycles outside 4000..4100"
times = [int(line[1:]) for line in open('wave.vcd') if line.startswith('#')]
assert times and 4000 <= min(times) <= max(times) <= 4100
PYTHON
checks=$((checks + 1))
expect 0 sim "$small" --dram-trace trace.txt --json report.json
python3 - <<'PYTHON' || fail "trace.txt does not hold the accesses"
import json, re
memory = json.load(open('report.json'))['memory']
lines = open('trace.txt').read().splitlines()
assert all(re.fullmatch(r'0x[0-9a-f]+ [RW]', line) and int(line.split()[0], 16) % 64 == 0 for line in lines)
assert sum(line.endswith('R') for line in lines) == memory['reads']['value'] > 0
assert sum(line.endswith('W') for line in lines) == memory['writes']['value'] > 0
PYTHON
checks=$((checks + 1))

# A lost answer: a deadlock, and who waits.
expect 2 sim "$small" --set dram.lose_answer=50 --set watchdog_cycles=5000 -o lost.cbvh --dram-trace lost.txt --vcd lost.vcd
says err "deadlock in cycle"
says err "box_builder waits for primitives from primitive_reader"
[[ -z $(find . -name 'lost*') ]] || fail "a file of a failed run is left"
checks=$((checks + 1))

# Refits: from a file and from a scene, moving, in place.
expect 0 refit tree.cbvh "$small" --json report.json
json "j['pass'] and j['frames'][0]['digest'] == '$digest'"
moving="proc:explode,triangles=2000"
expect 0 refit "$moving" "$moving,time={time}" --frames 4 --json report.json -o last.cbvh
json "j['pass'] and len({frame['digest'] for frame in j['frames']}) == 4"
json "all(frame['traffic_ratio'] < 0.6 for frame in j['frames'])"
expect 0 refit last.cbvh "$moving" --twist 0.25 --json report.json
json "j['pass']"

refuses "want a SCENE" sim
refuses "unknown 'fast'" sim "$small" --config fast
refuses "2000 triangles, max_triangles is 1999" sim "$small" --set max_triangles=1999
refuses "treelet: found 0, want 1..8" sim "$small" --set treelet=0
refuses "channels: 0, want a power of two" sim "$small" --set dram.channels=0
refuses "scratchpad_bytes: found 128" sim "$small" --set scratchpad_bytes=128
refuses "dram.capacity_bytes: found 65536" sim "$small" --set dram.capacity_bytes=65536
refuses "want NAME=VALUE" sim "$small" --set treelet
refuses "no module 'merger'" sim "$small" --vcd wave2.vcd --scope merger
refuses "goes with --vcd" sim "$small" --cycles 1:2
refuses "first 9 is after last 2" sim "$small" --vcd wave2.vcd --cycles 9:2
refuses "leaves no compressed tree" sim "$small" --config float -o tree2.cbvh
refuses "2000 triangles, the tree to refit has" refit "$moving" "$small"
refuses "nothing moves" refit "$moving" "$moving" --frames 3
refuses "found 0, want 1 or more" refit "$moving" "$moving" --frames 0
refuses "want a TREE and a SCENE" refit "$moving"
[[ ! -e wave2.vcd && ! -e tree2.cbvh ]] || fail "a refused run left a file"
