#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# animate: every policy's pictures are those of new trees; figures in JSON and CSV; errors by name.
source "$SOURCE/tests/end_to_end/command/expect.sh"

small=(--frames 6 --width 40 --height 30)
expect 0 animate "proc:explode,triangles=2000,time={time}" "${small[@]}" --json report.json --csv frames.csv
json "sorted(j['policies']) == ['async', 'heuristic', 'rebuild', 'refit'] and j['pass'] is True"
json "all(len(f) == 6 and all(x['same_picture'] and x['box_tests'] > 1200 for x in f) for f in j['policies'].values())"
json "all(x['sah'] == x['fresh_sah'] and x['age'] == 0 for x in j['policies']['rebuild'])"
json "[x['age'] for x in j['policies']['refit']] == list(range(6))"
json "j['policies']['refit'][5]['sah'] > 1.5 * j['policies']['refit'][5]['fresh_sah']"
head -1 frames.csv | grep -qx 'policy,frame,update_seconds,trace_seconds,sah,fresh_sah,box_tests,age,same_picture'
[[ $(wc -l <frames.csv) == 25 ]]
expect 0 animate proc:cloth --twist 0.2 "${small[@]}" --policy refit,async --json report.json
json "sorted(j['policies']) == ['async', 'refit']"

refuses "known: refit, rebuild, heuristic, async" animate proc:cloth --twist 1 --policy rest
refuses "nothing moves" animate proc:cloth
refuses "found 0, want 1 or more" animate proc:cloth --frames 0
refuses "wanted one of lbvh" animate proc:cloth --twist 1 --builder octree
refuses "--width: found 0, want 1..16384" animate proc:cloth --twist 1 --width 0
refuses "--threads: found 0" animate proc:cloth --twist 1 --threads 0
refuses "--rebuild-above: found 0.5, want 1 or more" animate proc:cloth --twist 1 --rebuild-above 0.5
