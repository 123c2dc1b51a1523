#!/bin/sh
# SPDX-License-Identifier: MIT
# Skin that knows its shape against light followed through the medium: bench/truth/shape.sh OUT [HEADS [SKINS
# [LIGHTS]]], from the root of the tree, after a build and ./run fetch-assets. Words separated by spaces:
#   HEADS   scan, built-in, ict, or a file of MakeHuman heads ("mh-african-man-young"); default all
#   SKINS   skin1 skin2 light medium dark
#   LIGHTS  side front behind
# SIZE (default 64x72), SUPERSAMPLE (16: a highlight on the rim of an ear is narrower than a quarter of
# such a pixel), SAMPLES (256; of dark skin, whose walks are the noisiest, four times as many) and FIT (of
# the profile) are of the environment. OUT keeps the references and one JSON per case; what is there is not
# made again. tools/shape_table.py OUT prints the tables.
set -eu
out=$1
heads=${2:-scan built-in ict mh-african-man-young mh-european-man-young mh-asian-woman-young}
skins=${3:-skin1 skin2 light medium dark}
lights=${4:-side front behind}
dermis=${DERMIS:-build/release/dermis}
assets=${DERMIS_ASSET_CACHE:-../shared/assets}
mkdir -p "$out"

# Spectral skins are those of the built-in head: docs/theory.md.
profile_of() {
  [ -f "$out/$1.json" ] && return
  case $1 in
    light) set -- "$1" --melanin 0.0245 --haemoglobin 0.0137 ;;
    medium) set -- "$1" --melanin 0.0613 --haemoglobin 0.0135 ;;
    dark) set -- "$1" --melanin 0.1123 --haemoglobin 0.0792 ;;
    *) set -- "$1" --preset "$1" ;;
  esac
  name=$1
  shift
  case $1 in --melanin) set -- "$@" --blend 0.1 --epidermis-mm 0.12 ;; esac
  # shellcheck disable=SC2086  # options are words
  "$dermis" profile "$@" ${FIT:+--fit $FIT} -o "$out/$name.json" >"$out/$name.txt"
}

for skin in $skins; do
  profile_of "$skin"
  for head in $heads; do
    case $head in
      scan) scene="assets/heads/lee-perry-smith.gltf --camera portrait" ;;
      built-in) scene="built-in --orbit 0,0" ;;
      ict) scene="$assets/ict-facekit/ict-mean-animated.glb --orbit 0,0" ;;
      *) scene="$assets/makehuman/$head.glb --orbit 0,0" ;;
    esac
    for light in $lights; do
      case $light in side) at=90,10 ;; front) at=0,20 ;; *) at=150,20 ;; esac
      [ -f "$out/$head-$skin-$light.result.json" ] && continue
      echo "$head-$skin-$light"
      samples=${SAMPLES:-256}
      [ "$skin" = dark ] && samples=$((4 * samples))
      truth=$out/$head-$skin-$light
      # shellcheck disable=SC2086
      [ -f "$truth.exr" ] || "$dermis" reference $scene --light $at --size "${SIZE:-64x72}" \
        --profile "$out/$skin.json" --model volume --samples "$samples" -o "$truth.exr" \
        --variance "$truth.variance.exr" >"$truth.reference.txt"
      # shellcheck disable=SC2086
      "$dermis" compare --scene $scene --light $at --shadow-size 4096 --map-size 1024 \
        --size "${SIZE:-64x72}" --supersample "${SUPERSAMPLE:-16}" --profile "$out/$skin.json" \
        --reference "$truth.exr" --variance "$truth.variance.exr" --techniques texture-space,lambert \
        --json "$truth.result.json" >"$truth.txt"
    done
  done
done
