#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# report: a page of every kind of result; what is broken or unknown, by its place; and the page in a real browser:
# no console message, no request, every plot with its text, light and dark. BROWSER=1 tests the latter alone.
source "$SOURCE/tests/end_to_end/command/expect.sh"

# picture FILE WIDTH HEIGHT
picture() {
  python3 - "$@" <<'PYTHON'
import struct, sys, zlib
name, width, height = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
chunk = lambda kind, data: struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
rows = b''.join(b'\0' + bytes(v for x in range(width) for v in (x * 255 // width, y * 255 // height, 128)) for y in range(height))
open(name, 'wb').write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0))
                       + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))
PYTHON
}

small="proc:spheres,triangles=2000,spheres=10"
expect 0 units --json units.json
expect 0 regress --unit axis_compressor --unit scale_estimator --json regress.json
expect 0 eval "$small" proc:cloth,sheet=20,height=20 --json eval.json
expect 0 eval builders "$small" --json builders.json
expect 0 eval two-level "bounce,count=20:$small" --json two_level.json
expect 0 eval space "rotated:proc:city,triangles=200" --rays 1000 --overlap 0,10,1000 --json space.json
expect 0 build "$small" --json build.json
expect 0 sim "$small" --json sim.json
expect 0 refit "$small" "$small" --twist 0.2 --frames 3 --json refit.json
expect 0 animate "proc:explode,triangles=2000,time={time}" --frames 6 --width 40 --height 30 --json animate.json
expect 0 bench --cases 1000 --scene "$small" --sizes 1000 3000 --json bench.json
picture 'a<b>&".png' 64 48
results=(units.json regress.json eval.json builders.json two_level.json space.json build.json sim.json refit.json animate.json bench.json)
expect 0 report "${results[@]}" 'a<b>&".png' -o report.html
says out "report.html: 11 results, 1 pictures;"

# browse PAGE OPTION...: opens it; messages are what its console has, requests what it asked the network for.
browse() {
  local page=$1
  shift
  rm -rf profile net.json
  timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars --user-data-dir="$PWD/profile" --no-first-run \
    --disable-background-networking --disable-component-update --disable-extensions --disable-sync --window-size=1100,4000 \
    --host-resolver-rules='MAP * ~NOTFOUND' --enable-logging=stderr --log-net-log="$PWD/net.json" "$@" "file://$PWD/$page" \
    >dom 2>log || { cat log; fail "chromium does not open $page"; }
  grep ':CONSOLE' log >messages || true
  # What the browser does of its own accord has no origin.
  python3 - >requests <<'PYTHON' || fail "$page: no log of the network"
import json
events = json.load(open('net.json'))['events']
assert events
for params in (event.get('params', {}) for event in events):
    if params.get('initiator', 'not an origin') != 'not an origin':
        print(params.get('url'))
PYTHON
}
silent() { [[ ! -s messages && ! -s requests ]]; }

if [[ -n ${BROWSER:-} ]]; then
  command -v chromium >/dev/null || { echo "skipped: no chromium"; trap - EXIT; exit 77; }
  browse report.html --dump-dom
  silent || { cat messages requests; fail "the page says or asks for something"; }
  python3 - <<'PYTHON' || fail "the page's structure"
from html.parser import HTMLParser

class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.ids, self.wanted, self.plots, self.tags = [], [], 0, []

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.tags.append(tag)
        if 'id' in values:
            self.ids.append(values['id'])
        if values.get('role') == 'img':
            self.plots += 1
            self.wanted += [values['aria-labelledby'], values['aria-describedby']]
        if tag == 'a':
            assert values['href'][0] == '#', values
            self.wanted.append(values['href'][1:])
        if tag == 'img':
            assert values['src'].startswith('data:image/png;base64,') and values['alt'], values
        else:
            assert 'src' not in values, values

page = Page()
text = open('dom').read()
page.feed(text)
assert page.plots >= 15, page.plots
assert page.tags.count('figcaption') == page.plots + 1 and page.tags.count('details') >= page.plots
assert len(page.ids) == len(set(page.ids)) and set(page.wanted) <= set(page.ids)
assert 'script' not in page.tags and 'link' not in page.tags
assert 'a&lt;b&gt;&amp;' in text and '✓ all checks passed' in text and 'cbvh regress --unit axis_compressor' in text
PYTHON
  checks=$((checks + 2))

  # The picture the browser makes: not empty, and of the scheme asked for.
  for scheme in 1:255,255,255 0:18,22,29; do
    browse report.html --screenshot="$PWD/page.png" --blink-settings=preferredColorScheme=${scheme%%:*}
    silent || { cat messages requests; fail "the page says or asks for something when it is drawn"; }
    python3 - "${scheme#*:}" <<'PYTHON' || fail "screenshot, scheme $scheme"
import struct, sys, zlib
data = open('page.png', 'rb').read()
offset, pixels = 8, b''
while offset < len(data):
    length, kind = struct.unpack('>I4s', data[offset:offset + 8])
    if kind == b'IDAT':
        pixels += data[offset + 8:offset + 8 + length]
    offset += length + 12
assert len(pixels) > 50000, len(pixels)
corner = zlib.decompress(pixels)[1:4]  # of the first row; no filter changes its first pixel
assert ','.join(map(str, corner)) == sys.argv[1], corner
PYTHON
    checks=$((checks + 2))
  done

  # This test sees what it looks for.
  sed 's|</main>|<img src="http://example.invalid/a.png" alt=""></main>|' report.html >blocked.html
  browse blocked.html --dump-dom
  [[ -s messages ]] || fail "a picture that the page's policy refuses goes unnoticed"
  sed 's|<meta http-equiv[^>]*>||' blocked.html >fetches.html
  browse fetches.html --dump-dom
  grep -qx 'http://example.invalid/a.png' requests || fail "a request goes unnoticed"
  sed 's|<meta http-equiv[^>]*>||; s|</main>|<script>nothing();</script></main>|' report.html >script.html
  browse script.html --dump-dom
  grep -q 'nothing is not defined' messages || fail "an error of a script goes unnoticed"
  checks=$((checks + 3))
  exit 0
fi

! grep -qiE 'src="?http|href="?http|<script|@import|url\(http' report.html || fail "the page refers to something outside"
grep -qF '<table' report.html && grep -qF '@media print' report.html && grep -qF 'prefers-color-scheme: dark' report.html
expect 0 report "${results[@]}" 'a<b>&".png' -o again.html
cmp report.html again.html || fail "the same files give another page"

# A failure, and nothing checked at all, are never green.
python3 - <<'PYTHON'
import json
result = json.load(open('build.json'))
result['identical'] = False
json.dump(result, open('differs.json', 'w'))
PYTHON
expect 1 report regress.json differs.json -o failed.html
says failed.html 'banner failed'
expect 1 report units.json 'a<b>&".png' -o none.html
says none.html 'nothing was checked'
! grep -q 'banner passed' none.html failed.html || fail "green without reason"

# What cannot be read is named, and leaves no page.
echo '{"scene": "x", "sum": 1}' >unknown.json
printf '{\n  "scene": x }\n' >broken.json
head -c 100 'a<b>&".png' >broken.png
python3 -c "
import json
result = json.load(open('eval.json'))
del result['tables']['figure1']['rows'][0]['strategy']
json.dump(result, open('lacks.json', 'w'))"
refuses "unknown.json: found an object with scene, sum, want the JSON of one of: cbvh regress" report unknown.json -o bad.html
refuses "broken.json:2:12: found byte 0x78, want JSON" report eval.json broken.json -o bad.html
refuses "broken.png:offset 33: PNG: found a chunk of" report broken.png -o bad.html
refuses "lacks.json: found a broken evaluation: [json.exception.out_of_range.403] key 'strategy' not found" report lacks.json -o bad.html
refuses "nothere.json: cannot read" report nothere.json -o bad.html
refuses "found ./eval.json, which is also read" report eval.json -o ./eval.json
refuses "nowhere/page.html" report regress.json -o nowhere/page.html
refuses "--output is required" report eval.json
refuses "report: " report -o bad.html
[[ ! -e bad.html ]] || fail "half a page"
