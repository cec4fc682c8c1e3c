#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# regress and merge: shards, threads and reports give one total.
source "$SOURCE/tests/end_to_end/command/expect.sh"

run=(regress --unit axis_compressor context_stack)
expect 0 "${run[@]}" --threads 1 --json report.json --junit whole.xml
total=$(tail -n 1 out)
[[ $total =~ ^[1-9][0-9]*\ passed,\ 0\ failed$ ]] || fail "the last line is not 'N passed, 0 failed'"
json "j['failed'] == 0 and j['seed'] == 1 and j['shard'] == '0/1' and j['corners']['axis_full_grid'] > 0"
python3 -c "import xml.dom.minidom; xml.dom.minidom.parse('whole.xml')" || fail "whole.xml is not XML"
expect 0 "${run[@]}" --threads 3
[[ $(tail -n 1 out) == "$total" ]] || fail "three threads count differently"
for i in 0 1 2; do
  expect 0 "${run[@]}" --shard $i/3 --json part$i.json
done
expect 0 merge part2.json part0.json part1.json --json report.json --junit merged.xml
[[ $(tail -n 1 out) == "$total" ]] || fail "shards add up to something else"
python3 -c "import xml.dom.minidom; xml.dom.minidom.parse('merged.xml')" || fail "merged.xml is not XML"
refuses "shard 1/3 is missing" merge part0.json part2.json
refuses "already in" merge part0.json part1.json part2.json part1.json
expect 0 "${run[@]}" --seed 2 --shard 1/3 --json other.json
refuses "seed" merge part0.json other.json part2.json
refuses "not a report" merge part0.json whole.xml
for stalls in none source sink both; do
  expect 0 regress --unit scale_estimator --stalls $stalls --shuffle 4 --json $stalls.json
done
expect 0 merge none.json source.json sink.json both.json
for seed in 1 2 3; do
  expect 0 regress --suite smoke --seed $seed
  [[ $(tail -n 1 out) =~ ^[1-9][0-9]{7,}\ passed,\ 0\ failed$ ]] || fail "the smoke suite's last line is not 'N passed, 0 failed' for seed $seed"
done

expect 0 regress --unit axis_compressor --set 'generated bits=6' --only 17 --stalls none
[[ $(tail -n 1 out) == "8 passed, 0 failed" ]] || fail "one case has 8 checks"
expect 1 regress --unit axis_compressor --set 'generated bits=6' --only 99999999
says out "zero checks"
refuses "known: smoke, full" regress --suite smoky
refuses "unknown unit 'axis'" regress --unit axis
refuses "known: board, gateware, golden, rtl" regress --backend fpga
refuses "--shard" regress --shard 4
refuses "--shard" regress --shard 5/4
refuses "nothere.glb" regress --scene nothere.glb
