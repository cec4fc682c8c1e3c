#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# build and validate, against the reference table of DESIGN 3.2.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 build proc:cloth --json report.json -o cloth.cbvh
json "(j['triangles'], j['leaves'], j['pairs'], j['e_min']) == (65000, 36722, 36721, -23)"
json "j['root_exponents'] == [-4, -4, -6]"
json "j['digest'] == j['topdown_digest'] == '8bd6f10416322ba7'"
json "j['identical'] is True and j['violations'] == 0 and j['streamed_by'] == 'rtl'"
json "j['backtracks'] == j['hardware_backtracks'] == 228 == sum(j['backtrack_depth_histogram'])"
json "all(k in j['traffic'][u] for u in ('lbvh', 'refit') for k in ('baseline_bytes', 'streaming_bytes', 'ratio'))"
json "j['sah']['float'] > 0 and j['sah']['quantized'] >= j['sah']['float']"
json "j['cycles'] > j['pairs'] and j['seconds'] > 0 and j['code'] == 'modulo' and j['treelet'] == 1 and j['bits'] == 6"
expect 0 build proc:cloth --code relative --treelet 2 --collector lazy --json report.json
json "j['digest'] == '8bd6f10416322ba7' and j['backtracks'] == 156"
expect 0 build proc:cloth --scale-rule figure5 --treelet 4 --json report.json
json "j['digest'] == 'a5e5eebd9bf15fb1' and j['backtracks'] == 24"
for bits in 2 8; do
  expect 0 build proc:cloth --bits $bits --json -
  python3 -m json.tool <out >/dev/null || fail "stdout is not JSON alone"
done

expect 0 validate cloth.cbvh --scene proc:cloth --json report.json
json "j['violations'] == 0 and j['digest'] == '8bd6f10416322ba7'"
expect 0 validate cloth.cbvh
head -c 5000 cloth.cbvh >short.cbvh
refuses "short.cbvh" validate short.cbvh
refuses "nothere.cbvh" validate nothere.cbvh

refuses "--streaming golden" build proc:cloth --min-scale -30
expect 0 build proc:cloth --min-scale -30 --streaming golden --json report.json
json "j['streamed_by'] == 'golden' and j['backtracks'] == 244 and j['e_min'] == -30"
refuses "--min-scale" build proc:cloth --min-scale low
refuses "-149..127" build proc:cloth --min-scale -150
refuses "--bits" build proc:cloth --bits 9
refuses "--treelet" build proc:cloth --treelet 9
refuses "known: modulo, relative" build proc:cloth --code modula
refuses "found 'bvh', wanted one of lbvh" build proc:cloth --builder bvh
refuses "option: found 'bins', but lbvh has none" build proc:cloth --builder lbvh,bins=4
refuses "known: full, lazy" build proc:cloth --collector best
refuses "known: rtl, golden" build proc:cloth --streaming board
refuses "cloth" build proc:clothes
refuses "nothere.glb" build nothere.glb
