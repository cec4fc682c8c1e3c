#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# eval rays: tests through trees of N = 4 to 8 over those through the float tree, every pixel the same; tables in JSON and CSV.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 eval rays proc:city,triangles=1000 proc:spheres,triangles=1000 --width 48 --height 36 --camera inside --json report.json --csv report.csv
json "j['failures'] == [] and j['checks'] == 2 * 3 * 48 * 36"
rows="j['tables']['ray_tests']['rows']"
json "len($rows) == 2 * 3 * 5 and {r['rays'] for r in $rows} == {'primary', 'ambient-occlusion', 'path'}"
json "all(r['box_ratio'] >= 1 and r['triangle_ratio'] >= 1 and r['count'] > 100 for r in $rows)"
# Finer codes cost less, on average.
average="j['tables']['ray_tests_average']['rows']"
json "$average[0]['box_ratio'] > $average[2]['box_ratio'] > $average[4]['box_ratio'] > 1"
json "[r['bits'] for r in $average] == [4, 5, 6, 7, 8] * 4 and $average[2]['paper_box_ratio'] == '1.08' and $average[0]['paper_box_ratio'] is None"
json "abs($average[2]['box_ratio'] - sum(r['box_ratio'] for r in $rows if r['bits'] == 6) / 6) < 1e-12"
grep -q '^ray_tests,.*proc:city,triangles=1000/primary/4.*,count,1728$' report.csv || fail "no row in the CSV"

refuses "wanted one of lbvh" eval rays proc:cloth --builder octree
refuses "--width: found 0" eval rays proc:cloth --width 0
refuses "known: modulo, relative" eval rays proc:cloth --code grey
refuses "nothere.glb" eval rays nothere.glb
