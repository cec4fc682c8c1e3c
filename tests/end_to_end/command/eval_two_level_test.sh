#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# eval two-level: every top level, over float and compressed object trees, streamed through the RTL, is the top-down one.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 eval two-level deal,objects=5,chunk=100:proc:spheres,triangles=5000 bounce,count=30,size=0.5,time=2:proc:soup,triangles=40 --json report.json --csv report.csv
rows="j['tables']['two_level']['rows']"
json "j['failures'] == [] and j['checks'] == 27 * len($rows) and len($rows) == 2 * 2 * 6"
json "{'plain', 'agglomerative', 'rebraid'} <= set(r['top'] for r in $rows)"
json "all(r['sah'] > 0 and r['compressed_ratio'] >= 1 and r['depth'] <= 32 for r in $rows)"
json "all(r['references'] == r['instances'] for r in $rows if r['top'] in ('plain', 'agglomerative'))"
json "all(r['references'] > r['instances'] for r in $rows if r['top'].startswith('rebraid'))"
json "all(r['single_ratio'] < r['sah_ratio'] < 1 for r in $rows if r['scene'].startswith('deal') and r['top'].startswith('rebraid'))"
grep -q '^two_level,.*/rebraid/compressed.*,instances,30$' report.csv
expect 0 eval two-level bounce,count=3:proc:soup,triangles=40 --top rebraid,width=4 --objects lbvh --most-single 10 --repeats 2 --json report.json
json "[r['top'] for r in $rows] == ['rebraid,width=4'] * 2 and all(r['single_ratio'] is None for r in $rows)"

refuses "wanted one of agglomerative, plain, rebraid" eval two-level --top none
refuses "wanted KIND:SCENE" eval two-level nothere.glb
refuses "wanted one of bounce, deal" eval two-level proc:cloth
refuses "--objects: found 'none'" eval two-level --objects none
refuses "--repeats: found 0" eval two-level --repeats 0
