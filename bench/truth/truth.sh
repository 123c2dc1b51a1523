#!/bin/sh
# SPDX-License-Identifier: MIT
# The figures of docs/accuracy.md: bench/truth/truth.sh OUT, from the root of the tree, after a build and
# ./run fetch-assets. TONE_MAP: of the display values (default natural).
# One JSON and one page a case; a case whose JSON is there is not made again. tools/truth_record.py OUT COMMIT
# writes the record.
set -eu
out=$1
dermis=${DERMIS:-build/release/dermis}
scan=assets/heads/lee-perry-smith.gltf
mkdir -p "$out"
[ -f "$out/skin2.json" ] || "$dermis" profile --preset skin2 -o "$out/skin2.json" >/dev/null

# case NAME OPTIONS: one hard light from the side unless they say otherwise
case_of() {
  name=$1
  shift
  if [ ! -f "$out/$name.result.json" ]; then
    echo "$name"
    "$dermis" compare "$@" --tone-map "${TONE_MAP:-natural}" --each-optimisation \
      --json "$out/$name.result.json" --html "$out/$name.html" >"$out/$name.txt"
  fi
}
side="--light 90,10 --shadow-size 8192"
small="--map-size 512 --profile $out/skin2.json"
# shellcheck disable=SC2086  # options are words
for view in 0 60; do
  case $view in 0) scan_view="--camera portrait" ;; *) scan_view="--orbit $view,0" ;; esac
  case_of "scan-$view-bssrdf" --scene "$scan" $scan_view $side --size 192x216 --map-size 1024 --samples 256
  case_of "built-in-$view-bssrdf" --scene built-in --orbit "$view,0" $side \
    --size 192x192 --map-size 1024 --samples 256
  case_of "scan-$view-skin2-bssrdf" --scene "$scan" $scan_view $side --size 96x108 $small --samples 256
  case_of "scan-$view-skin2-volume" --scene "$scan" $scan_view $side \
    --size 96x108 $small --model volume --samples 512
  case_of "built-in-$view-skin2-bssrdf" --scene built-in --orbit "$view,0" $side \
    --size 96x96 $small --samples 256
  case_of "built-in-$view-skin2-volume" --scene built-in --orbit "$view,0" $side \
    --size 96x96 $small --model volume --samples 512
done
# shellcheck disable=SC2086
case_of "scan-0-rig-bssrdf" --scene "$scan" --camera portrait --lights 2 --shadow-size 8192 \
  --size 192x216 --map-size 1024 --samples 256
