#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# eval builders: every builder's tree, streamed through the RTL, is the top-down one; tables in JSON and CSV.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 eval builders proc:cloth,sheet=20,height=20 proc:soup,triangles=500 --json report.json --csv report.csv
json "j['failures'] == [] and j['checks'] == 2 * 27 * len(set(r['builder'] for r in j['tables']['builder_trees']['rows']))"
json "{'lbvh', 'binned'} <= set(r['builder'] for r in j['tables']['builder_trees']['rows'])"
json "all(r['sah_float'] > 0 and r['sah_quantized_ratio'] >= 1 and r['depth'] <= 32 for r in j['tables']['builder_trees']['rows'])"
json "all(r['relative_1'] >= r['relative_4'] >= 0 and r['build_traffic_ratio'] < 1 for r in j['tables']['builder_compression']['rows'])"
# By hand, as many references as triangles: 40 + 64 + 4 bytes each and 16 a pair; refit 40 + 4 and 2 * 16; a backtrack 2 * 64.
json "all(abs(c['build_bytes'] * t['triangles'] - 108 * t['triangles'] - c['pairs'] * (16 + 128 * c['modulo_4'])) < 1e-3 and
  abs(c['refit_bytes'] * t['triangles'] - 44 * t['triangles'] - c['pairs'] * (32 + 128 * c['modulo_4'])) < 1e-3
  for t, c in zip(j['tables']['builder_trees']['rows'], j['tables']['builder_compression']['rows']) if t['builder'] == 'lbvh')"
grep -q '^builder_trees,.*proc:soup,triangles=500/lbvh.*,triangles,500$' report.csv
expect 0 eval builders proc:soup,triangles=400 --builder binned,bins=4 --builder lbvh --json report.json
json "[r['builder'] for r in j['tables']['builder_compression']['rows']] == ['binned,bins=4', 'lbvh']"
expect 0 eval proc:cloth,sheet=20,height=20 --only table1 --json report.json
json "'builder_trees' not in j['tables'] and 'table1' in j['tables']"

refuses "wanted one of lbvh" eval builders proc:cloth --builder octree
refuses "--repeats: found 0" eval builders proc:cloth --repeats 0
refuses "nothere.glb" eval builders nothere.glb
