#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every diff that ARCHITECTURE.md shows can be applied to the code as it stands.
set -euo pipefail
source_folder=$1
cd "$source_folder"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

awk -v folder="$scratch" '
  /^```diff$/ { inside = 1; ++count; next }
  /^```$/ { inside = 0 }
  inside { print > (folder "/" count ".diff") }' ARCHITECTURE.md

count=0
for diff in "$scratch"/*.diff; do
  [[ -f $diff ]] || break
  count=$((count + 1))
  # Context is what has to fit; where it stands in the file, patch finds by itself.
  if ! patch --dry-run --batch --forward --strip=1 --fuzz=0 --input="$diff" >"$scratch/said" 2>&1; then
    echo "ARCHITECTURE.md: diff $count does not fit the code any more:" >&2
    cat "$scratch/said" >&2
    exit 1
  fi
done

if ((count == 0)); then
  echo "ARCHITECTURE.md shows no diff" >&2
  exit 1
fi
echo "$count diffs fit"
