#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# make_complete.sh CBVH FOLDER [SCENE ...]: runs the commands of a complete report with that cbvh, their results in FOLDER, and makes
# FOLDER/report.html of them and of every picture there. Without scenes, built-in ones. Exit code: the report's.
set -euo pipefail
(($# >= 2)) || { echo "make_complete.sh CBVH FOLDER [SCENE ...]" >&2; exit 2; }
cbvh=$(realpath "$1")
folder=$2
shift 2
scenes=("$@")
((${#scenes[@]} > 0)) || scenes=(proc:cloth proc:spheres proc:terrain proc:hairball proc:city proc:explode)
mkdir -p "$folder"
# made NAME ARGUMENT...: a mismatch is the report's to show; what this machine lacks is left out of it, and said.
made() {
  local name=$1 code=0
  shift
  echo "cbvh $*"
  "$cbvh" "$@" --json "$folder/$name.json" >/dev/null || code=$?
  ((code != 77)) || { echo "  skipped"; return 0; }
  ((code <= 1)) || exit "$code"
}
made 01_units units
made 02_regress regress --suite smoke
made 03_lockstep lockstep --cycles 600
made 04_eval eval "${scenes[@]}"
made 05_builders eval builders "${scenes[@]}"
made 06_two_level eval two-level
made 06_space eval space
made 06_rays eval rays "${scenes[@]}"
made 07_build build "${scenes[0]}"
made 08_sim sim "${scenes[0]}"
made 09_refit refit "${scenes[0]}" "${scenes[0]}" --twist 0.2 --frames 4
made 10_animate animate 'proc:explode,time={time}'
made 11_bench bench
# picture NAME SCENE ARGUMENT...: four images of a scene through one kind of rays.
picture() {
  local name=$1
  shift
  for image in shaded box-tests triangle-tests difference; do
    made "12_trace_${name}_$image" trace "$@" --image "$image" -o "$folder/${name}_$image.png"
  done
}
for scene in "${scenes[@]}"; do
  name=$(basename "${scene//:/_}")
  picture "${name%%[.,]*}" "$scene" --rays ambient-occlusion
  made "13_hits_${name%%[.,]*}" trace "$scene" --compare embree --incoherent 200000 --width 128 --height 96
done
picture bounce "bounce,count=256:${scenes[0]}" --rays ambient-occlusion
shopt -s nullglob
exec "$cbvh" report "$folder"/*.json "$folder"/*.png -o "$folder/report.html"
