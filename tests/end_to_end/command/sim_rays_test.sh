#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# sim-rays: what it prints and writes, and what it refuses.
source "$SOURCE/tests/end_to_end/command/expect.sh"

small="proc:city,triangles=2000"
for rays in primary diffuse; do
  expect 0 sim-rays "$small" --rays $rays --width 24 --height 24 --json report.json
  says out "every nearest hit is the golden's"
  json "j['pass'] and j['wrong'] == 0 and j['rays'] > 50 and j['hits'] > 5"
  json "j['unit']['pairs'] >= j['exact_boxes']['pairs'] >= j['float_tree']['pairs'] > 0"
  json "0 < j['unit']['pair_bytes'] < j['float_tree']['pair_bytes']"
done
# The same work whatever the memory, the order and the number of rays on their way; only cycles differ.
expect 0 sim-rays "$small" --width 24 --height 24 --json report.json
unit=$(python3 -c "import json; u = json.load(open('report.json'))['unit']; print([u[k] for k in ('pairs', 'leaves', 'triangles')])")
for disturbance in "--stalls 3" "--shuffle 5" "--set memory=ideal" "--slots 1" "--slots 64" "--set code=relative"; do
  # shellcheck disable=SC2086
  expect 0 sim-rays "$small" --width 24 --height 24 $disturbance --json report.json
  json "[j['unit'][k] for k in ('pairs', 'leaves', 'triangles')] == $unit"
done
expect 0 sim-rays "$small" --width 8 --height 8 --set bits=4
refuses "--slots: found 65, want 1..64" sim-rays "$small" --slots 65
refuses "--width: found 0" sim-rays "$small" --width 0
refuses "--rays: unknown 'shadow'" sim-rays "$small" --rays shadow
refuses "want a SCENE" sim-rays
