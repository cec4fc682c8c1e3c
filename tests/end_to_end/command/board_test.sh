#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# Backend board and `cbvh board`: without a board, and with the emulated one on every transport, good and misbehaving.
source "$SOURCE/tests/end_to_end/command/expect.sh"
sets=$SOURCE/vectors/sets

refuses "backend board cannot be made to stall" check "$sets/axis_compressor.vec" --backend board --stalls both
# A board of this id is nowhere: nothing is run, and nothing reported as passed.
for command in "board info" "board selftest" "board bench" "check $sets/axis_compressor.vec --backend board" "regress --backend board"; do
  expect 77 $command --device usb:1209:ffff
  [[ ! -s out && $(wc -l <err) == 1 ]] || fail "$command without a board: one line on stderr and no output"
done

if grep -q 'built without libusb' err; then echo "skipped: built without libusb"; trap - EXIT; exit 77; fi
refuses "found 'nowhere', want usb:VVVV:PPPP, serial=TEXT or BUS:ADDRESS" board info --device nowhere
emulator=$(dirname "$CBVH")/../fpga/emulator/cbvh_emulator
[[ -x $emulator ]] || { echo "skipped: no emulated board (libusb, umockdev)"; trap - EXIT; exit 77; }
"$emulator" -- true >out 2>err || { cat err; echo "skipped: the emulated board does not run here"; trap - EXIT; exit 77; }

# with "OPTION..." EXIT_CODE ARGUMENT...: cbvh beside an emulated board.
with() {
  local options=$1 want=$2 found=0
  shift 2
  timeout 60 "$emulator" $options -- "$CBVH" "$@" >out 2>err </dev/null || found=$?
  ((found == want)) || fail "board $options: cbvh $*: exit code $found, want $want"
  checks=$((checks + 1))
}

expect 0 check "$sets/axis_compressor.vec"
tail -n 1 out >rtl_axis
expect 0 check "$sets/stream_compressor.vec"
tail -n 1 out >rtl_stream
for transport in bulk ftdi-uart ftdi-fifo; do
  for unit in axis stream; do
    with "--transport $transport" 0 check "$sets/${unit}_compressor.vec" --backend board
    says out "corners of the model: not observed by board, golden"
    tail -n 1 out | cmp - rtl_$unit || fail "$unit over $transport: counts differ from rtl"
  done
done

with "" 0 board list --json report.json
json "len(j['boards']) == 1 and j['boards'][0]['id'] == '1209:b5c0' and j['boards'][0]['taken']"
with "" 0 board info --device 1:2 --json report.json
json "len(j['units']) > 20 and j['corrupted'] == 0"
with "--transport ftdi-fifo" 0 board info --device serial=EMULATED
with "--transport ftdi-fifo" 0 board info --device usb:0403:6014
with "" 77 board info --device serial=other
with "" 0 board selftest --cases 20 --json report.json
json "j['failed'] == 0 and j['passed'] > 100000 and len({s['unit'] for s in j['sets']}) > 20"
with "" 0 board bench --cases 20000 --repeat 2 --json report.json
json "j['failures'] == 0 and j['checks'] == 320000 and j['vectors'] == 40000"
json "0 < j['to_board']['overhead_percent'] < 3 and 0 < j['from_board']['overhead_percent'] < 3"
json "j['to_board']['bytes'] > j['to_board']['payload'] and j['high_speed_vectors_per_second'] > 1000000"
CBVH_BOARD=serial=EMULATED with "" 0 regress --backend board --unit context_stack
says out "0 failed"

# What the board does not have is neither run nor passed.
with "--unit axis_compressor" 77 check "$sets/stream_compressor.vec" --backend board
says err "has no unit 'stream_compressor', only: axis_compressor"
with "--bits 4" 77 check "$sets/axis_compressor.vec" --backend board
says err "with N = 6 D = 1, only: N = 4 D = 1"

# A link that misbehaves: complete and right, or an error that says how far it came.
expect 0 gen --unit axis_compressor --cases 60000 -o many.bin
faults=(stall nak short babble corrupt drop duplicate delay reorder reconnect)
transports=(bulk ftdi-fifo)
for i in "${!faults[@]}"; do
  with "--transport ${transports[i % 2]} --fault ${faults[i]}:0.03" 0 check many.bin --backend board --link-timeout 200
  says out "960000 passed, 0 failed"
done
with "--fault disconnect:0.2 --seed 3" 2 check many.bin --backend board --link-timeout 200
[[ ! -s out ]] || fail "output although the board went"
says err "plug it in again"
