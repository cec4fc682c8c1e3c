#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# Twins that were broken on purpose fail their vectors. With WHEN=nightly all of gateware_mutants.txt, and lockstep finds
# them, too, where it has the twin; else its ci lines.
source "$SOURCE/tests/end_to_end/command/expect.sh"
command -v iverilog >/dev/null || { echo "skipped: no iverilog"; trap - EXIT; exit 77; }
gateware=$SOURCE/fpga/gateware
export CBVH_GATEWARE=$PWD/broken
refuses "found '?', want " lockstep '?'
lockstep_twins=" $(sed 's/.*want //; s/,//g' err) "

# mutant UNIT STALLS FILE SED
mutant() {
  local unit=$1 stalls=$2 file=$3 script=$4
  rm -rf broken && mkdir broken && cp "$gateware"/*.v "$gateware"/*.vh broken
  sed -i "$script" "broken/$file"
  [[ $(diff "$gateware/$file" "broken/$file" | grep -c '^>') == 1 ]] || fail "mutant $file '$script': not one line changed"
  [[ $stalls == - ]] || expect 1 check "$SOURCE/vectors/sets/$unit.vec" --backend gateware --stalls "$stalls"
  if [[ $WHEN == nightly && $lockstep_twins == *" $unit "* ]]; then
    expect 1 lockstep "$unit" --cycles 3000
    says out ", Verilog "
  fi
}

mutants=0
while read -r when unit stalls file script; do
  if [[ $when == '#' || ($when == nightly && $WHEN != nightly) ]]; then continue; fi
  mutant "$unit" "$stalls" "$file" "$script"
  mutants=$((mutants + 1))
done <"$SOURCE/tests/end_to_end/command/gateware_mutants.txt"
((mutants >= 10)) || fail "only $mutants mutants"
echo "$mutants mutants"
