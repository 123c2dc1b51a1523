#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# bench_against.sh OLD NEW [OPTION...]   Times frames of two builds of the program in turns, A B A B, and
# prints a row of a Markdown table per cell: the median frame of each in ms, and their ratio.
#
#   git worktree add ../before COMMIT; (cd ../before && ./run build)
#   NEW_OPTIONS="--set quality.light_samples=1" tools/bench_against.sh \
#     ../before/build/release/dermis build/release/dermis --size 960x600 --map-size 1024 --shadow-size 1024
#
#   OPTION...    of both programs; those of `dermis render`
#   SCENE        glTF file (default assets/heads/lee-perry-smith.gltf)
#   HEADS        default "1 4 16"
#   DISTANCES    radii, default "2.5 10 50 100"
#   TURNS        of each program and cell, default 3; FRAMES of a turn, default 3
#   OLD_OPTIONS, NEW_OPTIONS  of one program alone; --set quality.keep_shadows=false where the other draws
#                shadow maps in every frame
set -euo pipefail

if (($# < 2)); then
  sed -n '3,/^set/p' "$0" | sed '$d; s/^# \{0,1\}//' >&2
  exit 2
fi
old=$1 new=$2
shift 2
scene=${SCENE:-assets/heads/lee-perry-smith.gltf}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# frame_ms PROGRAM OPTION...: prints the median frame of one turn
frame_ms() {
  local program=$1
  shift
  "$program" render "$scene" "$@" --translucency off --frames "${FRAMES:-3}" \
    --stats "$scratch/stats.json" -o "$scratch/picture.exr" >"$scratch/log" 2>&1 ||
    { cat "$scratch/log" >&2; return 1; }
  python3 -c 'import json, sys; print(json.load(sys.stdin)["frame_ms"]["median"])' <"$scratch/stats.json"
}

median() { python3 -c 'import statistics, sys; print(statistics.median(map(float, sys.stdin)))'; }

echo "| heads/distance | old ms | new ms | old / new |"
echo "|---|---|---|---|"
for heads in ${HEADS:-1 4 16}; do
  for distance in ${DISTANCES:-2.5 10 50 100}; do
    : >"$scratch/old"
    : >"$scratch/new"
    cell=(--heads "$heads" --distance "$distance" "$@")
    for ((turn = 0; turn < ${TURNS:-3}; ++turn)); do
      # Word splitting is meant: several options in one variable.
      # shellcheck disable=SC2086
      frame_ms "$old" "${cell[@]}" ${OLD_OPTIONS:-} >>"$scratch/old"
      # shellcheck disable=SC2086
      frame_ms "$new" "${cell[@]}" ${NEW_OPTIONS:-} >>"$scratch/new"
    done
    awk -v cell="$heads/$distance" -v a="$(median <"$scratch/old")" -v b="$(median <"$scratch/new")" \
      'BEGIN {printf "| %s | %.0f | %.0f | %.2f |\n", cell, a, b, a / b}'
  done
done
