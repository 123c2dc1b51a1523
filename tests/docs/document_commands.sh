#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# document_commands.sh SOURCE BUILD LEAST DOCUMENT...   The commands of these documents that start the
# program, as they are printed, in a folder that has the assets of the tree and nothing else. Blocks after a
# line "<!-- not run: why -->" are left out and listed; commands that open a window are left out. LEAST: so
# many there must be.
set -euo pipefail
source_folder=$1 build_folder=$2 least=$3
export XDG_CACHE_HOME=$build_folder/cache
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir -p "$place/build" "$place/out"
ln -s "$build_folder" "$place/build/release"
ln -s "$source_folder/assets" "$place/assets"
cd "$source_folder"
documents=()
for document in "${@:4}"; do documents+=("$source_folder"/$document); done  # patterns
cd "$place"

scan=true
"$source_folder/tools/fetch_assets.sh" --cached >log 2>&1 || scan=false
ran=0 skipped=0
while IFS=$'\t' read -r document why command; do
  if [[ -n ${why// /} ]]; then echo "not run, $why: $command"; continue; fi
  if [[ $command == *lee-perry-smith* && $scan == false ]]; then skipped=$((skipped + 1)); continue; fi
  began=$SECONDS
  bash -c "$command" >log 2>&1 || { echo "failed, of $document: $command"; cat log; exit 1; }
  if ((SECONDS - began > 20)); then echo "$((SECONDS - began)) s: $command"; fi
  ran=$((ran + 1))
done < <(awk '
  FNR == 1 { why = " "; inside = 0 }
  /^<!-- not run: / { why = substr($0, 15, length($0) - 18) }
  /^```/ { inside = !inside; if (!inside) why = " " }
  inside && /^build\/release\/dermis / && !/ view / { print FILENAME "\t" why "\t" $0 }' "${documents[@]}")
[ $((ran + skipped)) -ge "$least" ] || { echo "there are only $((ran + skipped)) commands"; exit 1; }
if [ "$scan" = false ]; then echo "$skipped commands skipped: the scan is not at hand"; fi
echo "$ran commands run as printed"
