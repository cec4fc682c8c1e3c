#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# gen and check: every format, every backend, every stall mode; and files that are wrong.
source "$SOURCE/tests/end_to_end/command/expect.sh"

for extension in vec hex bin; do
  expect 0 gen --unit axis_compressor --cases 300 --seed 5 -o "a.$extension"
  expect 0 check "a.$extension" --json report.json
  [[ $(tail -n 1 out) == "4800 passed, 0 failed" ]] || fail "300 cases of 8 checks, twice"
  json "j['passed'] == 4800 and j['failed'] == 0"
  expect 0 check "a.$extension" --backend golden
  [[ $(tail -n 1 out) == "2400 passed, 0 failed" ]] || fail "300 cases of 8 checks"
done
for stalls in none source sink both; do
  expect 0 check a.vec --stalls $stalls --shuffle 9
done
expect 0 gen --unit node_pair_compressor --bits 4 --cases 50 -o pairs.vec
expect 0 check pairs.vec
expect 0 gen --unit context_stack --cases 20 -o stack.bin
expect 0 check stack.bin --stalls both

for unit in axis_compressor backtrack_unit stream_compressor; do
  expect 0 gen --unit $unit --scene proc:cloth --cases 40 -o captured.vec
  says captured.vec " captured "
  expect 0 check captured.vec
done
refuses "clothes" gen --unit axis_compressor --scene proc:clothes -o captured.vec

expect 0 check a.vec --only 17 --dump-case
says out "# cbvh-vectors 1 unit=axis_compressor"
[[ $(tail -n 1 out) == "16 passed, 0 failed" ]] || fail "one case"
refuses "no case has id 300" check a.vec --only 300

# A wrong response that carries a right checksum is a mismatch, with the line that reruns it.
python3 - <<'PY'
import re
lines = open('a.vec').read().split('\n')
at = next(i for i, line in enumerate(lines) if line.startswith('17 '))
head, tail = lines[at].split(' > ')
digit = tail[0]
lines[at] = head + ' > ' + ('1' if digit == '0' else '0') + tail[1:]
def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8): crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF
end = next(i for i, line in enumerate(lines) if line.startswith('# end'))
before = lines[end][:lines[end].index('crc32c=') + len('crc32c=')]
body = '\n'.join(lines[:end] + [before])
lines[end] = before + '%08X' % crc32c(body.encode())
open('wrong.vec', 'w').write('\n'.join(lines))
PY
expect 1 check wrong.vec --json report.json
says out "case 17"
says out "field code_lo"
says out "rerun: cbvh check 'wrong.vec' --backend golden"
[[ $(tail -n 1 out) == "4798 passed, 2 failed" ]] || fail "the golden and the model disagree with the file"
json "j['failed'] == 2 and j['sets'][0]['mismatches'][0]['id'] == 17"

refuses "nothere.vec" check nothere.vec
head -c 400 a.vec >short.vec
refuses "short.vec" check short.vec
sed '3s/0/1/' a.vec >crc.vec
cmp -s a.vec crc.vec && fail "nothing was changed"
expect 2 check crc.vec
refuses "--backend" check a.vec --backend fpga
says err "known: board, gateware, golden, rtl"
refuses "known: none, source, sink, both" check a.vec --stalls some
refuses "unknown unit 'axis'" gen --unit axis -o b.vec
refuses "b.txt" gen --unit axis_compressor -o b.txt
refuses "2, 3, 4, 5, 6, 7, 8" gen --unit axis_compressor --bits 9 -o b.vec
refuses "--cases" gen --unit axis_compressor --cases 0 -o b.vec
refuses "nodir/b.vec" gen --unit axis_compressor --cases 4 -o nodir/b.vec
