#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# eval space: trees of space beside trees of objects, every one covering its triangles and giving rays the same hits.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 eval space rotated:proc:city,triangles=150 --rays 2000 --overlap 0,10 --json report.json --csv report.csv
json "j['failures'] == [] and j['checks'] == 2 + 4 * (len(j['tables']['space']['rows']) - 1 + 2)"
json "{'C-BVH', 'G-BVH', 'KD-BVH', 'SS-BVH'} <= set(r['tree'] for r in j['tables']['space']['rows'])"
json "all(r['paper_size_ratio'] is None for r in j['tables']['space']['rows'])"
json "all(r['through_cost'] > r['terminating_cost'] > 0 for r in j['tables']['space_rays']['rows'])"
json "all(abs(r['through_cost'] / r['expected'] - 1) < 0.05 for r in j['tables']['space_rays']['rows'])"
json "[r['overlap'] for r in j['tables']['space_overlap']['rows']] == [0, 10]"
grep -q '^space,.*/SS-BVH"*,terminating_ratio,0\.' report.csv || fail "report.csv lacks SS-BVH's terminating_ratio"
expect 0 eval space rotated:proc:city,triangles=150 --rays 2000 --overlap 0,10 --threads 2 --json other.json
python3 - <<'PYTHON' || fail "threads change results"
import json
def figures(name):
    tables = json.load(open(name))['tables']
    for row in tables['space']['rows']: del row['build_seconds']
    return tables
assert figures('report.json') == figures('other.json')
PYTHON
expect 0 eval space proc:soup,triangles=200 --builder sweep --builder geometric --rays 500 --overlap 1 --json report.json
json "[r['tree'] for r in j['tables']['space']['rows']] == ['sweep', 'geometric']"

refuses "wanted one of lbvh" eval space proc:cloth --builder octree
refuses "--rays: found 0" eval space proc:cloth --rays 0
refuses "cbvh: --overlap: option overlap: found '-1'" eval space proc:soup,triangles=20 --overlap -1
refuses "its box has no volume" eval space proc:terrain,height=0,triangles=50
refuses "nothere.glb" eval space nothere.glb
