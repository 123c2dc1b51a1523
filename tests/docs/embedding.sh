#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the library into an empty folder, builds docs/embedding against it as an engine would, runs it
# under the validation layer, and holds its last frame against the renderer's own picture.
set -euo pipefail
source_folder=$1 build_folder=$2 cmake=$3 generator=$4 cxx=$5 c=$6
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

fail() { echo "$1"; exit 1; }
quiet() { "$@" > "$place/log" 2>&1 || { cat "$place/log"; fail "failed: $*"; }; }

lines=$(wc -l < "$source_folder/docs/embedding/embedding.cpp")
[ "$lines" -lt 300 ] || fail "embedding.cpp has $lines lines; a sample of 300 or more shows too much"

quiet "$cmake" --install "$build_folder" --component development --prefix "$place/installed"
# A copy: nothing of the source tree must be in reach of the sample.
cp -r "$source_folder/docs/embedding" "$place/embedding"
quiet "$cmake" -S "$place/embedding" -B "$place/build" -G "$generator" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$cxx" \
  -DCMAKE_C_COMPILER="$c" -DCMAKE_PREFIX_PATH="$place/installed"
quiet "$cmake" --build "$place/build"

# No message of the validation layer on any frame, nor when the device is destroyed, and no warning of dermis.
frames=24
cd "$place"
build/embedding frame.ppm --frames $frames --linear frame.pfm --validate > said 2> messages ||
  fail "embedding failed: $(cat said messages)"
cat said
if grep -E '^(validation|dermis): ' messages; then fail "these are messages"; fi
grep -q "$frames frames, the last of 400 x 320 pixels" said || fail "it did not draw what it was told to"
if compgen -G "/usr/share/vulkan/explicit_layer.d/*khronos_validation*" > /dev/null; then
  grep -q "0 messages" said || fail "the validation layer is installed, but did not watch"
fi
[ "$(head -c 15 frame.ppm | tr '\n' ' ')" = "P6 400 320 255 " ] || fail "frame.ppm is no picture of that size"
build/compare frame.pfm $frames || fail "the frame is not what the renderer draws"

# What differs is seen: the frame before is another picture.
if build/compare frame.pfm $((frames - 1)) > said; then
  fail "another frame compares as equal: $(cat said)"
fi

# Ways (ii) and (iv): ends with 1 if the layer says something, if the bar throws no shadow on the skin, or if
# frames ask the device for something.
quiet build/shadows_of_the_host shadows.ppm
cp shadows.ppm again.ppm
quiet build/shadows_of_the_host shadows.ppm
cmp shadows.ppm again.ppm || fail "two runs of shadows_of_the_host differ"

# One frame has no resize, and nothing in flight before it.
quiet build/embedding one.ppm --frames 1 --validate

# refuses STATUS TEXT COMMAND ...: ends with that status, says that on standard error, and writes no picture.
refuses() {
  local status=$1 text=$2 found=0
  shift 2
  "$@" > said 2> messages || found=$?
  [ $found = "$status" ] || fail "'$*' ended with status $found, not $status: $(cat messages)"
  grep -qF -e "$text" messages || fail "'$*' does not say '$text': $(cat messages)"
  [ ! -e no.ppm ] || fail "'$*' wrote a picture"
}
for words in "" "--frames 3" "no.ppm --frames" "no.ppm --frames 0" "no.ppm --frames -1" "no.ppm --frames 2x" \
  "no.ppm --frames 99999999999999999999" "no.ppm --linear" "no.ppm other.ppm" "no.ppm --wrong"; do
  # shellcheck disable=SC2086
  refuses 2 "usage: embedding" build/embedding $words
done
refuses 1 "missing/no.ppm: cannot be written" build/embedding missing/no.ppm --frames 1
for words in "" "frame.pfm" "frame.pfm x" "frame.pfm -1" "frame.pfm 1 2"; do
  # shellcheck disable=SC2086
  refuses 2 "usage: compare" build/compare $words
done
refuses 1 "missing.pfm: is not" build/compare missing.pfm 1
refuses 1 "frame.ppm: is not" build/compare frame.ppm 1
head -c 1000 frame.pfm > short.pfm
refuses 1 "short.pfm: ends too early" build/compare short.pfm 1
