#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The command line itself, units, and what is unknown.
source "$SOURCE/tests/end_to_end/command/expect.sh"

expect 0 --version
says out "cbvh 0."
expect 0 --help
for command in bench build check eval gen help merge refit regress sim units validate; do
  says out "$command"
  expect 0 "$command" --help
  expect 0 help "$command"
  expect 0 --help
done
refuses "subcommand is required"
refuses "unknown 'biuld', known:" biuld
refuses "unknown 'biuld', known:" help biuld
refuses "unknown '--treelets', known:" build proc:cloth --treelets 4

expect 0 units --json report.json
for unit in axis_compressor scale_estimator node_pair_compressor context_stack box_decoder ray_setter pair_intersector traversal_unit; do says out "$unit"; done
json "len(j['units']) >= 5 and all(u['stimulus'] and u['response'] and u['latency'] for u in j['units'])"
json "all('rtl' in u['faces'] and 'golden' in u['faces'] for u in j['units'])"
expect 0 units axis_compressor
says out "lower:upper:scale"
refuses "axis_compressor" units axis
expect 0 units --json -
python3 -m json.tool <out >/dev/null || fail "stdout is not JSON alone"
