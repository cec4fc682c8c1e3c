#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# trace: pictures are PNG files with what they claim to show, the same through every tree; figures in JSON; errors by name.
source "$SOURCE/tests/end_to_end/command/expect.sh"

# picture FILE EXPRESSION: true in python, with width, height and rows of (red, green, blue) of an 8-bit RGB PNG.
picture() {
  python3 - "$1" "$2" <<'PYTHON' || fail "$1: not $2"
import struct, sys, zlib
data = open(sys.argv[1], 'rb').read()
assert data[:8] == b'\x89PNG\r\n\x1a\n'
offset, packed = 8, b''
while offset < len(data):
    length, kind = struct.unpack('>I4s', data[offset:offset + 8])
    if kind == b'IHDR': width, height, depth, colours = struct.unpack('>IIBB', data[offset + 8:offset + 18])
    if kind == b'IDAT': packed += data[offset + 8:offset + 8 + length]
    offset += length + 12
assert (depth, colours) == (8, 2)
raw, rows, above = zlib.decompress(packed), [], bytes(3 * width)
for y in range(height):
    kind, line = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
    for i in range(3 * width):
        a, b, c = line[i - 3] if i > 2 else 0, above[i], above[i - 3] if i > 2 else 0
        nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        line[i] = (line[i] + [0, a, b, (a + b) // 2, nearest][kind]) % 256
    above = bytes(line)
    rows.append([tuple(line[i:i + 3]) for i in range(0, 3 * width, 3)])
pixels = [pixel for row in rows for pixel in row]
sys.exit(not eval(sys.argv[2]))
PYTHON
  checks=$((checks + 1))
}

small=(--width 48 --height 36)
sky='(150, 180, 220)'
spheres=proc:spheres,triangles=2000
expect 0 trace "$spheres" "${small[@]}" -o shaded.png --json report.json
says out "1728 pixels the same through all 2 trees, 0 not"
json "j['different_pixels'] == 0 and j['different_trees'] == 0 and j['tree_checks'] == 1 and j['pass'] is True"
json "j['float']['primary']['rays'] == 48 * 36 and j['float']['secondary']['rays'] == 0 and j['ratio']['secondary']['box_tests'] is None"
json "j['ratio']['primary']['box_tests'] == j['compressed']['primary']['box_tests'] / j['float']['primary']['box_tests'] > 1"
hits=$(python3 -c "import json; print(json.load(open('report.json'))['hits'])")
picture shaded.png "(width, height) == (48, 36) and 0 < sum(p != $sky for p in pixels) == $hits < 1728"
picture shaded.png "all(p == $sky or p[0] == p[1] == p[2] for p in pixels) and len(set(pixels)) > 40"
expect 0 trace "$spheres" "${small[@]}" -o normals.png --image normals
picture normals.png "sum(p != (0, 0, 0) for p in pixels) == $hits"
picture normals.png "all(p == (0, 0, 0) or abs(sum((2 * v / 255 - 1) ** 2 for v in p) - 1) < 0.03 for p in pixels)"
for tests in box triangle; do
  for tree in float compressed; do
    expect 0 trace "$spheres" "${small[@]}" --bits 3 -o "$tests-$tree.png" --image "$tests-tests" --tree "$tree" --json report.json
    picture "$tests-$tree.png" "(255, 255, 255) in pixels and len(set(pixels)) > 5"
    json "j['most_${tests}_tests'] > 5"
  done
  ! cmp -s "$tests-float.png" "$tests-compressed.png" || fail "the heat maps of both trees are alike"
done
expect 0 trace "$spheres" "${small[@]}" -o difference.png --image difference
picture difference.png "set(pixels) == {(0, 0, 0)}"

# Every tree gives the same picture, whoever made it.
for rays in ambient-occlusion path; do
  expect 0 trace "$spheres" "${small[@]}" --camera inside --rays "$rays" --samples 2 --check --json report.json
  json "[t['tree'] for t in j['trees']] == ['float', 'streaming', 'top-down', 'float refitted', 'refitted']"
  json "j['pass'] and j['different_pixels'] == 0 and j['tree_checks'] == 3"
  json "j['trees'][1]['secondary'] == j['trees'][2]['secondary'] != j['trees'][4]['secondary'] and j['trees'][4]['secondary']['rays'] > 500"
done
for compression in streaming top-down refitted; do
  expect 0 trace "$spheres" "${small[@]}" --rays path --samples 1 --compression "$compression" -o "$compression.png"
  cmp streaming.png "$compression.png" || fail "another picture through the $compression tree"
  checks=$((checks + 1))
done
for options in "--bits 8 --code relative" "--bits 2 --builder binned" "--threads 1" "--tree float"; do
  read -ra words <<<"$options"
  expect 0 trace "$spheres" "${small[@]}" --rays path --samples 1 "${words[@]}" -o other.png
  cmp streaming.png other.png || fail "another picture with $options"
  checks=$((checks + 1))
done

# Instances are drawn through a top level.
expect 0 trace "bounce,count=9,size=0.6:$spheres" "${small[@]}" --rays ambient-occlusion --samples 1 --check -o bounce.png --json report.json
json "[t['tree'] for t in j['trees']] == ['float', 'streaming', 'top-down'] and j['pass'] and j['hits'] > 40"
picture bounce.png "len(set(pixels)) > 1"

# One ray, and every ray's hit against Embree's.
expect 0 trace "$spheres" --ray 0,0,-9,0,0,1 --json report.json
json "j['pass'] and j['float']['hits'] == j['compressed']['hits'] and j['float']['box_tests'] > 1"
code=0
"$CBVH" trace "$spheres" "${small[@]}" --rays path --samples 1 --compare embree --incoherent 5000 --axis-parallel 5000 --edges 5000 --vertices 5000 --json report.json >out 2>err || code=$?
if ((code == 77)); then
  says err "this build has no Embree"
else
  ((code == 0)) || fail "--compare embree: exit code $code"
  rows="j['tables']['embree_hits']['rows']"
  json "[r['set'] for r in $rows] == ['picture', 'incoherent', 'axis-parallel', 'edges', 'vertices', 'all'] and j['failures'] == []"
  json "j['checks'] == 2 * $rows[5]['count'] and $rows[1]['count'] == 5000 and $rows[0]['count'] > 1728"
  json "all(r['lost'] == r['not_hit'] == r['wrong_distance'] == r['tree_differences'] == 0 < r['same'] for r in $rows)"
  json "all(sum(r[k] for k in ('nothing', 'same', 'equal_distance', 'embree_rounds', 'distance_rounds')) == r['count'] for r in $rows)"
fi

# Every interval of the traversal unit encloses the exact one.
for bits in 4 6; do
  expect 0 trace "$spheres" "${small[@]}" --camera inside --rays path --samples 1 --intervals --bits "$bits" --json report.json
  json "j['failures'] == [] and j['tables']['box_intervals']['rows'][0]['box_tests'] > 50000 and j['tables']['box_intervals']['rows'][0]['exact_ratio'] >= 1"
done

# The page of a report takes both.
expect 0 trace "$spheres" "${small[@]}" -o shaded.png --json report.json
expect 0 report report.json shaded.png -o page.html
says page.html "cbvh trace $spheres --width 48 --height 36 -o shaded.png --json report.json"

refuses "known: shaded, normals, box-tests, triangle-tests, difference" trace proc:cloth --image depth
refuses "known: primary, ambient-occlusion, path" trace proc:cloth --rays light
refuses "known: streaming, top-down, refitted" trace proc:cloth --compression zip
refuses "--bits: found 9, want 2..8" trace proc:cloth --bits 9
refuses "--width: found 0, want 1..16384" trace proc:cloth --width 0
refuses "--height: found 16385" trace proc:cloth --height 16385
refuses "want at most 33554432 pixels" trace proc:cloth --width 16384 --height 16384
refuses "--samples: found 0" trace proc:cloth --samples 0
refuses "want around, inside or" trace proc:cloth --camera above
refuses "found '1,2', want three numbers" trace proc:cloth --camera 1,2:3,4,5
refuses "want an eye beside its target" trace proc:cloth --camera 1,2,3:1,2,3
refuses "want finite numbers" trace proc:cloth --camera nan,2,3:1,2,3
refuses "wanted a finite number" trace proc:cloth --camera 1e39,2,3:1,2,3
refuses "half height 0" trace proc:cloth --camera 1,2,5:1,2,3:0
refuses "want streaming or top-down" trace "bounce,count=4:$spheres" --compression refitted
refuses "wanted one of lbvh" trace proc:cloth --builder octree
refuses "cannot be written" trace "$spheres" "${small[@]}" -o no/such/folder.png
refuses "no such file" trace missing.glb
refuses "wanted a component that is not zero" trace proc:cloth --ray 1,2,3,0,0,-0
refuses "wanted a finite number" trace proc:cloth --ray 1,2,3,0,inf,0
refuses "wanted an interval" trace proc:cloth --ray 1,2,3,0,1,0,2,1
refuses "found 3 numbers" trace proc:cloth --ray 1,2,3
refuses "known: embree" trace proc:cloth --compare luxrender

# A picture that is interrupted leaves no file.
mkdir interrupted
"$CBVH" trace "$spheres" --rays path --samples 4000 -o interrupted/a.png >/dev/null 2>&1 &
sleep 1
kill -TERM $!
! wait $! || fail "it was done before it could be interrupted"
[[ -z $(ls interrupted) ]] || fail "left: $(ls interrupted)"
checks=$((checks + 1))
