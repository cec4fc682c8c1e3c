#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# eval two-level: every top level, over float and compressed object trees, streamed through the RTL, is the top-down one.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 eval two-level deal,objects=5,chunk=100:proc:spheres,triangles=5000 bounce,count=30,size=0.5,time=2:proc:soup,triangles=40 --json report.json --csv report.csv
rows="j['tables']['two_level']['rows']"
json "j['failures'] == [] and j['checks'] == 27 * len($rows) and len($rows) == 2 * 2 * 7"
json "{'plain', 'agglomerative', 'rebraid'} <= set(r['top'] for r in $rows)"
json "all(r['sah'] > 0 and r['compressed_ratio'] >= 1 and r['depth'] <= 32 for r in $rows)"
json "all(r['references'] == r['instances'] for r in $rows if r['top'] in ('plain', 'agglomerative'))"
json "all(r['references'] > r['instances'] for r in $rows if r['top'].startswith('rebraid'))"
json "all(r['single_ratio'] < r['sah_ratio'] < 1 for r in $rows if r['scene'].startswith('deal') and r['top'].startswith('rebraid'))"
grep -q '^two_level,.*/rebraid/compressed.*,instances,30$' report.csv
expect 0 eval two-level bounce,count=3:proc:soup,triangles=40 --top rebraid,width=4 --objects lbvh --most-single 10 --repeats 2 --json report.json
json "[r['top'] for r in $rows] == ['rebraid,width=4'] * 2 and all(r['single_ratio'] is None for r in $rows)"

# Every frame: the same picture through every top level, over float and compressed trees.
expect 0 eval two-level bounce,count=60,size=0.3,speed=5,time={time}:proc:soup,triangles=300,size=0.5 --frames 4 --top plain --top agglomerative --top agglomerative,search=scan --top rebraid --width 64 --height 48 --threads 2 --json report.json --csv report.csv
frames="j['tables']['two_level_every_frame']['rows']"
json "j['failures'] == [] and j['checks'] == len($frames) == 4 * 2 * 4"
json "all(r['pictures'] == 'all the same' and 0 < r['build_ms'] <= r['build_ms_max'] for r in j['tables']['two_level_frames']['rows'])"
json "len(set(r['picture'] for r in $frames)) == 4 and len(set((r['frame'], r['picture']) for r in $frames)) == 4"
json "all(r['rays'] == 64 * 48 and 300 < r['hits'] and r['transforms'] > r['hits'] for r in $frames)"
json "len(set((r['sah'], r['box_tests'], r['trees']) for r in $frames if r['top'].startswith('agglomerative'))) == 8"
json "[r['sah'] for r in $frames if r['trees'] == 'compressed'] > [r['sah'] for r in $frames if r['trees'] == 'float']"
json "all(r['references'] > 60 for r in $frames if r['top'] == 'rebraid')"
grep -q '^two_level_every_frame,.*/rebraid/compressed/3",build_ms,0' report.csv

cp report.json frames.json
expect 0 eval two-level bounce,count=60,size=0.3,speed=5,time=0:proc:soup,triangles=300,size=0.5 --top rebraid --json report.json
first="{r['trees']: r['sah'] for r in __import__('json').load(open('frames.json'))['tables']['two_level_every_frame']['rows'] if r['top'] == 'rebraid' and r['frame'] == 0}"
json "(lambda sah: sah['float'] == $rows[0]['sah'] and abs(sah['compressed'] / ($rows[1]['sah'] * $rows[1]['compressed_ratio']) - 1) < 1e-12)($first)"

refuses "nothing moves in bounce:proc:soup" eval two-level bounce:proc:soup --frames 2
refuses "--width: found 0" eval two-level bounce:proc:soup --frames 1 --width 0
refuses "wanted one of agglomerative, plain, rebraid" eval two-level --top none
refuses "wanted KIND:SCENE" eval two-level nothere.glb
refuses "wanted one of bounce, deal" eval two-level proc:cloth
refuses "--objects: found 'none'" eval two-level --objects none
refuses "--repeats: found 0" eval two-level --repeats 0
