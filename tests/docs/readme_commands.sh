#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The commands of README.md that start the program, as they are printed, in a folder that has what the README
# names and nothing else. Those that open a window are left out.
set -euo pipefail
source_folder=$1 build_folder=$2
export XDG_CACHE_HOME=$build_folder/cache
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir -p "$place/build" "$place/out"
ln -s "$build_folder" "$place/build/release"
ln -s "$source_folder/assets" "$place/assets"
cd "$place"

scan=true
"$source_folder/tools/fetch_assets.sh" --cached >log 2>&1 || scan=false
ran=0 skipped=0
while read -r command; do
  if [[ $command == *lee-perry-smith* && $scan == false ]]; then skipped=$((skipped + 1)); continue; fi
  bash -c "$command" >log 2>&1 || { echo "failed: $command"; cat log; exit 1; }
  ran=$((ran + 1))
done < <(awk '/^```/ { inside = !inside } inside && /^build\/release\/dermis / && !/ view /' \
  "$source_folder/README.md")
[ $((ran + skipped)) -ge 10 ] || { echo "README.md has $((ran + skipped)) commands"; exit 1; }
if [ "$scan" = false ]; then echo "$skipped commands skipped: the scan is not at hand"; fi
echo "$ran commands of README.md run as printed"
