#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# picture_hashes.sh [NAME...]   Draws the pictures of tests/golden/pictures.txt, all or those named, and
# prints the sha256 of each: of its light (EXR) and of what is displayed (PNG). A change that only moves code
# leaves every line as it is on the same device:
#
#   tools/picture_hashes.sh >before.txt; (the change, a build); tools/picture_hashes.sh | diff before.txt -
#
#   DERMIS              the program (default build/release/dermis)
#   DERMIS_ASSET_CACHE  folder of the heads and surroundings (default ../shared/assets); what needs a file
#                       that is not there is left out, with a note
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

dermis=${DERMIS:-build/release/dermis}
assets=${DERMIS_ASSET_CACHE:-../shared/assets}
list=tests/golden/pictures.txt
scan=assets/heads/lee-perry-smith.gltf
defaults=(--size=120x135 --map-size=512 --shadow-size=512)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# draw NAME ARGUMENTS...: prints a line, or says why there is none
draw() {
  local name=$1 argument option
  shift
  for argument in "$@"; do
    if [[ ($argument == *.gltf || $argument == *.glb || $argument == *.hdr) && ! -f $argument ]]; then
      echo "note: $name is left out: there is no $argument" >&2
      return
    fi
  done
  for option in "${defaults[@]}"; do
    [[ " $* " == *" ${option%%=*} "* ]] || set -- "$@" "$option"
  done

  local -a hashes=()
  for option in exr png; do
    "$dermis" render "$@" -o "$scratch/picture.$option" >"$scratch/log" 2>&1 || {
      echo "error: $name: $(tail -n 1 "$scratch/log")" >&2
      exit 1
    }
    hashes+=("$(sha256sum <"$scratch/picture.$option" | cut -c1-32)")
  done
  printf '%-24s %s %s\n' "$name" "${hashes[@]}"
}

while IFS=$'\t' read -r name arguments; do
  [[ -n $name && $name != \#* ]] || continue
  [[ $# -eq 0 || " $* " == *" $name "* ]] || continue
  arguments=${arguments//\{scan\}/$scan}
  read -ra words <<<"${arguments//\{assets\}/$assets}"
  draw "$name" ${words[@]+"${words[@]}"}
done <"$list"
