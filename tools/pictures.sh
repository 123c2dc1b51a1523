#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# pictures.sh [NAME...]   Makes the pictures of README.md and docs/ again (docs/pictures), all of them or
# those named, with the commands that the pages print. Asks for imagemagick, which joins pictures; keeps what
# it renders in out/pictures.
#   DERMIS        the program (default build/release/dermis)
#   MAKEHUMAN     folder of the MakeHuman heads, for `tone-maps` (default ../shared/assets/makehuman)
#   ENVIRONMENTS  folder of venice_sunset_1k.hdr and studio_small_09_1k.hdr (default
#                 ../shared/assets/environments)
set -euo pipefail
cd "$(dirname "$0")/.."

dermis=${DERMIS:-build/release/dermis}
makehuman=${MAKEHUMAN:-../shared/assets/makehuman}
environments=${ENVIRONMENTS:-../shared/assets/environments}
scan=assets/heads/lee-perry-smith
out=out/pictures
names=(hard-light ear-from-behind three-skins environments soft-shadows truth-side truth-studio shape-aware
  regions skin-sets tone-maps turntable head-studio head-hard-light peers peers-heads)

fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

say() { printf '+ %s\n' "$*"; }

# render NAME ARGUMENTS...: out/pictures/NAME.png
render() {
  say "dermis render ${*:2} -o $out/$1.png"
  "$dermis" render "${@:2}" -o "$out/$1.png" >"$out/$1.txt"
}

# compare NAME ARGUMENTS...: out/pictures/NAME.html, .json and .txt
compare() {
  say "dermis compare ${*:2} --html $out/$1.html"
  "$dermis" compare "${@:2}" --html "$out/$1.html" --json "$out/$1.json" >"$out/$1.txt"
}

# from_page NAME ID: the picture with this id in out/pictures/NAME.html, as out/pictures/NAME-ID.png
from_page() {
  python3 - "$out/$1.html" "$2" "$out/$1-$2.png" <<'PYTHON'
import base64, re, sys
page, name, target = sys.argv[1:]
text = open(page, encoding="utf-8").read()
found = re.search(r'<img id="%s"[^>]*src="data:image/png;base64,([^"]+)"' % re.escape(name), text)
if not found: sys.exit(f"error: {page} has no picture '{name}'")
open(target, "wb").write(base64.b64decode(found.group(1)))
PYTHON
}

# join NAME SIZE PICTURE...: side by side, each at this size, as docs/pictures/NAME.jpg
join() {
  convert "${@:3}" -filter Lanczos -resize "$2!" +append -quality 88 -strip "docs/pictures/$1.jpg"
}

# with_errors NAME SIZE REFERENCE A B ERROR_A ERROR_B: above the pictures, below the errors of A and B
with_errors() {
  convert \( "${@:3:3}" -filter Lanczos -resize "$2!" +append \) \
    \( "${@:6:2}" -filter Lanczos -resize "$2!" +append \) \
    -gravity east -background black -append -quality 88 -strip "docs/pictures/$1.jpg"
}

# pair NAME HEAD OPTION...: out/pictures/NAME.png, and NAME-lambert.png without scattering
pair() {
  render "$@"
  render "$1-lambert" "${@:2}" --technique lambert
}

side_light=(--light 72,22,4.5 --light=-70,5,0.2 --ambient 0.04 --background "#3a424d")

hard-light() {
  pair $1 $scan.gltf --eye 0.09,0.075,0.62 --target 0.01,0.058,0.05 --fov 16.5 "${side_light[@]}" \
    --size 600x660
  join $1 600x660 $out/$1.png $out/$1-lambert.png
}

ear-from-behind() {
  pair $1 $scan.gltf --eye 0.3,0.085,0.4 --target 0.079,0.078,-0.005 --fov 8.5 --light 158,8,12 \
    --light 20,20,0.5 --ambient 0.06 --background "#3a424d" --size 600x540
  join $1 600x540 $out/$1.png $out/$1-lambert.png
}

three-skins() {
  local skin
  for skin in light medium dark; do
    pair $1-$skin built-in:$skin --eye 0.14,0.02,0.75 --target 0.004,0.005,0.05 --fov 20 \
      "${side_light[@]}" --map-size 1024 --size 400x480
  done
  convert \( $out/$1-{light,medium,dark}.png +append \) \
    \( $out/$1-{light,medium,dark}-lambert.png +append \) -append -quality 88 -strip "docs/pictures/$1.jpg"
}

environments() {
  local common=($scan.gltf --camera portrait --size 640x720 --lights 0 --exposure auto)
  render studio "${common[@]}" --environment studio
  render venice "${common[@]}" --environment "$environments/venice_sunset_1k.hdr"
  render small "${common[@]}" --environment "$environments/studio_small_09_1k.hdr"
  join $1 427x480 $out/studio.png $out/venice.png $out/small.png
}

soft-shadows() {
  local radius
  for radius in 0 0.1 0.4; do
    render soft-$radius $scan.gltf --camera portrait --size 640x720 --light 60,35 --light-radius $radius
  done
  join $1 427x480 $out/soft-0.png $out/soft-0.1.png $out/soft-0.4.png
}

# Of fewer samples than the tables of docs/accuracy.md have: enough for a picture.
side() {
  [[ -e $out/side.html ]] ||
    compare side --scene $scan.gltf --camera portrait --light 90,10 \
    --size 320x360 --shadow-size 8192 --optimise none --samples 256
}

truth-side() {
  side
  local id
  for id in reference technique-0 technique-2 technique-0-error technique-2-error; do from_page side $id; done
  with_errors $1 256x288 $out/side-{reference,technique-0,technique-2,technique-0-error,technique-2-error}.png
}

regions() {
  side
  local id
  for id in 1 2 3 4 5 6; do from_page side region-$id; done
  join $1 213x240 $out/side-region-{1,2,3,4,5,6}.png
}

truth-studio() {
  compare studio-truth --scene $scan.gltf --camera portrait --environment studio \
    --lights 0 --size 320x360 --samples 384 \
    --techniques texture-space,lambert
  local id
  for id in reference technique-0 technique-0-error; do from_page studio-truth $id; done
  join $1 320x360 $out/studio-truth-{reference,technique-0,technique-0-error}.png
}

shape-aware() {
  "$dermis" profile --preset skin2 -o $out/skin2.json >/dev/null
  compare shape --scene $scan.gltf --camera portrait --light 90,10 --size 200x225 --shadow-size 4096 \
    --supersample 4 --profile $out/skin2.json --model volume --samples 256 --techniques texture-space
  local id
  for id in reference technique-{1,0} technique-{1,0}-error; do from_page shape $id; done
  with_errors $1 256x288 $out/shape-{reference,technique-1,technique-0}.png \
    $out/shape-technique-{1,0}-error.png
}

# No tone map: the curves and strips of a plot.
skin-sets() {
  "$dermis" profile --preset skin-layers -o $out/layers.json >/dev/null
  "$dermis" profile --melanin 0.02 --compare skin --compare $out/layers.json \
    --plot docs/pictures/$1.svg >/dev/null
}

# Above as the former default showed them, below as the default does.
tone-maps() {
  local tone_map
  for tone_map in filmic natural; do
    for who in african european; do
      render $who-$tone_map "$makehuman/mh-$who-man-young.glb" --size 480x540 \
        --light 40,30 --exposure auto --tone-map $tone_map
    done
  done
  convert \( $out/african-filmic.png $out/european-filmic.png +append \) \
    \( $out/african-natural.png $out/european-natural.png +append \) \
    -append -quality 88 -strip docs/pictures/$1.jpg
}

# head_sheet NAME LIGHT...: the built-in head from eight sides (columns), in its three skins (rows): front,
# three quarters, profile, behind, below, near the eye, the ear, the mouth.
head_sheet() {
  local name=$1 skin view rows=()
  shift
  for skin in light medium dark; do
    local row=()
    for view in "--orbit=0,0" "--orbit=35,5" "--orbit=90,0" "--orbit=180,0" "--orbit=25,-35" \
      "--eye 0.06,0.03,0.4 --target 0.031,0.036,0.08 --fov 9" \
      "--eye 0.4,0.03,0.03 --target 0.075,0.02,-0.01 --fov 13" \
      "--eye 0.1,-0.02,0.4 --target 0,-0.035,0.09 --fov 11"; do
      [[ $view == --eye* ]] || view="$view --distance 6 --fov 17"
      # shellcheck disable=SC2086
      render $name-$skin-${#row[@]} built-in:$skin --size 240x288 --map-size 1024 $view "$@"
      row+=("$out/$name-$skin-${#row[@]}.png")
    done
    convert "${row[@]}" +append "$out/$name-$skin.png"
    rows+=("$out/$name-$skin.png")
  done
  convert "${rows[@]}" -append -quality 88 -strip "docs/pictures/$name.jpg"
}

head-studio() { head_sheet $1 --environment studio --background studio --light 40,30,2; }

head-hard-light() { head_sheet $1 --light 60,25,4 --ambient 0.03; }

# peers_row NAME SIZE ARGUMENTS...: truth and techniques, below maps of FLIP; out/pictures/NAME.png
peers_row() {
  compare $1 "${@:3}" --techniques all --model gaussians --size $2 --samples 128
  local id row=() errors=()
  for id in 0 3 4 5 6 2; do
    from_page $1 technique-$id
    from_page $1 technique-$id-error
    row+=($out/$1-technique-$id.png) errors+=($out/$1-technique-$id-error.png)
  done
  from_page $1 reference
  convert \( $out/$1-reference.png "${row[@]}" +append \) \
    \( -size $2 xc:black "${errors[@]}" +append \) -append $out/$1.png
}

peers() {
  peers_row peers 240x240 --scene test:nose --supersample 1
  convert $out/peers.png -quality 88 -strip docs/pictures/$1.jpg
}

peers-heads() {
  peers_row peers-scan 200x230 --scene $scan.gltf --light 60,20 --fov 10 --shadow-size 4096
  peers_row peers-african 200x230 --scene "$makehuman/mh-african-man-young.glb" --light 60,20 --fov 6
  peers_row peers-asian 200x230 --scene "$makehuman/mh-asian-woman-young.glb" --light 60,20 --fov 6
  convert $out/peers-{scan,african,asian}.png -append -quality 85 -strip docs/pictures/$1.jpg
}

# sequence NAME ARGUMENTS...: the contact sheet, as docs/pictures/NAME.jpg
sequence() {
  say "dermis sequence ${*:2} -o $out/$1-%02d.png --sheet $out/$1.png"
  "$dermis" sequence "${@:2}" -o "$out/$1-%02d.png" --sheet "$out/$1.png" >"$out/$1.txt"
  convert "$out/$1.png" -quality 88 -strip "docs/pictures/$1.jpg"
}

turntable() {
  sequence $1 $scan.gltf --orbit -15,5..105,5 --fps 6 --to 1 --light 72,22,4.5 \
    --light=-70,5,0.2 --ambient 0.04 --background "#3a424d" --size 300x320
}

[[ -x $dermis ]] || fail "$dermis is not there; ./run build makes it"
wanted=("$@")
if [[ $# -eq 0 ]]; then wanted=("${names[@]}"); fi
for name in "${wanted[@]}"; do
  [[ " ${names[*]} " == *" $name "* ]] || fail "no picture is called '$name'; there are: ${names[*]}"
done
tools/install_packages.sh -- imagemagick python3
mkdir -p $out
for name in "${wanted[@]}"; do
  say "docs/pictures/$name"
  "$name" "$name"
done
