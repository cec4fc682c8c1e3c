#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# eval: its three outputs agree, and give the reference results of DESIGN 3.2.
source "$SOURCE/tests/end_to_end/command/expect.sh"

small="proc:spheres,triangles=2000,spheres=10"
counted=figure1,table1,table3,figure7,figure10
expect 0 eval proc:cloth "$small" --only $counted --min-scales auto,-10 --json report.json --csv report.csv
says out "32 checks passed, 0 failed"
json "j['checks'] == 32 and j['failures'] == [] and j['scale_rule'] == 'equation2' and j['min_scale'] == 'auto'"
json "list(j['tables']) == ['scenes', 'figure1', 'table1', 'table3', 'figure7', 'figure10', 'figure10_scenes']"
json "[j['tables']['scenes']['rows'][0][f'{c}_{d}'] for c in ('relative', 'modulo') for d in (1, 2, 3, 4)] == [19275, 156, 38, 0, 228, 22, 0, 0]"
json "[(r['backtracks_1'], r['backtracks_4']) for r in j['tables']['figure10_scenes']['rows'] if r['scene'] == 'proc:cloth'] == [(228, 0), (48, 0)]"
json "'spirit' in j['tables']['scenes']['rows'][0]['note'] and j['tables']['scenes']['rows'][1]['note'] is None"

# agree TEXT CSV: every figure of the JSON is in the CSV, once and equal, and each table of the text has the JSON's rows.
agree() {
  python3 - "$1" "$2" <<'PYTHON' || fail "the outputs differ"
import csv, json, sys
tables = json.load(open('report.json'))['tables']
cells = {}
for line in csv.DictReader(open(sys.argv[2], newline='')):
    place = (line['table'], line['row'], line['column'])
    assert place not in cells, place
    cells[place] = line['value']
labels = {'scenes': 1, 'figure1': 3, 'table1': 3, 'table3': 2, 'figure7': 2, 'figure10': 1, 'figure10_scenes': 2}
figures = 0
for name, table in tables.items():
    for row in table['rows']:
        values = list(row.items())
        label = '/'.join(str(value) for _, value in values[:labels[name]])
        for key, value in values[labels[name]:]:
            if value is None:
                assert (name, label, key) not in cells
                continue
            found = cells.pop((name, label, key))
            assert (found if isinstance(value, str) else float(found)) == value, (name, label, key)
            figures += 1
assert not cells and figures > 300, (cells, figures)

blocks = {}
for block in open(sys.argv[1]).read().split('## ')[1:]:
    title, *lines = block.split('\n')
    rows = [[cell.strip() for cell in line[1:-1].split(' |')] for line in lines if line.startswith('|')]
    assert len({len(row) for row in rows}) == 1, title
    blocks[title] = rows[2:]
for name, table in tables.items():
    if name == 'figure10_scenes':
        continue
    rows = blocks.pop(table['title'])
    assert len(rows) == len(table['rows']) > 0
    for text, row in zip(rows, table['rows']):
        for shown, value in zip(text, row.values()):
            if value is None:
                assert shown == '-'
            elif isinstance(value, float):
                digits = len(shown.partition('.')[2])
                assert abs(float(shown) - value) <= 0.5000001 * 10 ** -digits, (name, shown, value)
            else:
                assert shown == str(value), (name, shown, value)
assert not blocks
PYTHON
  checks=$((checks + 1))
}
agree out report.csv

# Any number of threads, the same results but for the command line; - is stdout.
json "j['made_by']['command_line'] == 'cbvh eval proc:cloth $small --only $counted --min-scales auto,-10 --json report.json --csv report.csv'"
without_command_line() { grep -v '"command_line": "cbvh eval '; }
without_command_line <report.json >first.json
expect 0 eval proc:cloth "$small" --only $counted --min-scales auto,-10 --jobs 1 --json - --csv report.csv
without_command_line <out | cmp - first.json || fail "one thread gives another JSON"
agree err report.csv
expect 0 eval proc:cloth "$small" --only $counted --min-scales auto,-10 --csv -
cmp out report.csv || fail "stdout is not the CSV alone"

# The simulated runtimes: the scene's row, the averages over the scenes, what the bytes need, and the paper's rows.
expect 0 eval proc:cloth "$small" --only table2 --json report.json --csv report.csv
json "list(j['tables']) == ['scenes', 'table2', 'figure11', 'table2_bound', 'table2_paper']"
json "len(j['tables']['table2']['rows']) == 2 and len(j['tables']['table2_paper']['rows']) == 16"

expect 0 eval proc:cloth --only table1 --scale-rule figure5 --json report.json
json "list(j['tables']) == ['scenes', 'table1'] and j['tables']['scenes']['rows'][0]['relative_1'] == 20814"
expect 0 eval proc:cloth --only figure7,figure1 --min-scale -30 --json report.json
json "list(j['tables']) == ['scenes', 'figure1', 'figure7'] and j['tables']['scenes']['rows'][0]['modulo_1'] == 244"
# A scene that is one leaf has nothing to normalize to.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >leaf.obj
expect 0 eval leaf.obj --json report.json
json "all(r['average'] == 1 for r in j['tables']['table1']['rows']) and j['checks'] == 16"
# Two files of one name are called by their paths.
mkdir a b
cp leaf.obj a
cp leaf.obj b
expect 0 eval a/leaf.obj b/leaf.obj --only table3 --json report.json
json "[r['scene'] for r in j['tables']['scenes']['rows']] == ['a/leaf.obj', 'b/leaf.obj']"

refuses "proc:cloth: scene: given twice" eval proc:cloth "$small" proc:cloth
refuses "unknown 'table9', known: figure1, table1" eval proc:cloth --only table1,table9
refuses "nothere.glb" eval proc:cloth nothere.glb
refuses "known: equation2, figure5" eval proc:cloth --scale-rule figure4
refuses "--min-scale" eval proc:cloth --min-scale low
refuses "-149..127" eval proc:cloth --min-scales -30,-150
refuses "twice" eval proc:cloth --min-scales -30,-30
refuses "--csv" eval proc:cloth --json - --csv -
