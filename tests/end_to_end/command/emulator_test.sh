#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# The emulated board: the vectors of every unit through it, and the program that plugs it in.
source "$SOURCE/tests/end_to_end/command/expect.sh"

emulator=$(dirname "$CBVH")/../fpga/emulator/cbvh_emulator
[[ -x $emulator ]] || { echo "skipped: no umockdev or no libusb"; trap - EXIT; exit 77; }

# runs EXIT_CODE ARGUMENT...: the emulator; its output and the command's are in the files out and err.
runs() {
  local want=$1 found=0
  shift
  "$emulator" "$@" >out 2>err </dev/null || found=$?
  ((found == want)) || fail "cbvh_emulator $*: exit code $found, want $want"
  checks=$((checks + 1))
}

# Every unit's committed vectors, over the transports in turn: the same counts as the rtl backend.
transports=(bulk ftdi-uart ftdi-fifo)
count=0
for set in "$SOURCE"/vectors/sets/*.vec; do
  transport=${transports[count % 3]}
  runs 0 --transport $transport -- "$CBVH" check "$set" --backend board
  grep -q ' board ' out || fail "$set: the board is not in the report"
  tail -n 1 out >board
  expect 0 check "$set" --backend rtl
  tail -n 1 out | cmp - board || fail "$set over $transport: counts differ between board and rtl"
  count=$((count + 1))
done
((count >= 25)) || fail "only $count vector sets"

# Every twin's, with its Verilog inside the board.
if command -v iverilog >/dev/null; then
  twins=0
  for set in "$SOURCE"/vectors/sets/*.vec; do
    unit=$(basename "$set" .vec)
    [[ -e $SOURCE/fpga/gateware/$unit.v ]] || continue
    treelet=$(grep -om1 'treelet=[0-9]*' "$set")
    runs 0 --core gateware --unit $unit --treelet ${treelet#*=} -- "$CBVH" check "$set" --backend board --link-timeout 60000
    tail -n 1 out >board
    expect 0 check "$set" --backend rtl
    tail -n 1 out | cmp - board || fail "$set: counts differ between the board with gateware and rtl"
    twins=$((twins + 1))
  done
  ((twins == 9)) || fail "$twins twins behind the link, want 9"
fi

# Faults are drawn from the seed: a run is repeatable, and says what it did.
expect 0 gen --unit axis_compressor --cases 60000 -o many.bin
runs 0 --fault corrupt:0.2 --seed 2 --verbose -- "$CBVH" check many.bin --backend board --link-timeout 200
says err "plugged in 1 times, corrupt "
runs 0 --fault reconnect:0.05 --seed 4 --verbose -- "$CBVH" check many.bin --backend board --link-timeout 200
grep -qE 'plugged in [2-9] times, reconnect [1-9]' err || fail "the board did not come back"

# The exit code is the command's; what is wrong with the emulator's own options is said in one line.
for code in 0 1 5 77; do runs $code -- sh -c "exit $code"; done
runs 137 -- sh -c 'kill -9 $$'
for wrong in "--transport x" "--core x" "--fault x" "--fault drop:2" "--unit x" "--bits 9" "--treelet 9" "--nonsense"; do
  runs 2 $wrong -- true
  [[ ! -s out && $(wc -l <err) == 1 ]] || fail "cbvh_emulator $wrong: one line on stderr and no output"
  grep -qE '^cbvh_emulator: .' err || fail "cbvh_emulator $wrong: not 'cbvh_emulator: what'"
done
runs 2 -- /no/such/program
says err "cbvh_emulator: /no/such/program: cannot run it"
runs 2
says err "COMMAND: found none"
runs 0 --help
says out "--fault"
