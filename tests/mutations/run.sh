#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh SOURCE BUILD [NAME...]   Builds a copy of the sources with one fault at a time, NAME.patch beside
# this file, and runs the cases of the short tier that its line "Seen by:" names: one has to fail. Without
# NAME: every fault. The copy and its build are kept in BUILD/mutants, so that a second run compiles little.
set -uo pipefail
source_folder=$1 build_folder=$2
here=$source_folder/tests/mutations copy=$build_folder/mutants/source built=$build_folder/mutants/build
export DERMIS_ASSET_CACHE=${DERMIS_ASSET_CACHE:-$source_folder/../shared/assets}

fail() { echo "$1"; exit 1; }
quiet() { "$@" >"$log" 2>&1 || { tail -n 30 "$log"; fail "failed: $*"; }; }

names=("${@:3}")
if [ ${#names[@]} -eq 0 ]; then
  for patch in "$here"/*.patch; do names+=("$(basename "$patch" .patch)"); done
fi
# "Seen by: TEST FILTER" of a fault.
seen_by() { sed -n 's/^Seen by: //p' "$here/$1.patch"; }
build() { cmake --build "$built" --parallel "${DERMIS_JOBS:-$(nproc)}" --target "$@"; }
test_of() {
  local name filter program
  read -r name filter <<<"$(seen_by "$1")"
  program=$(find "$built/tests" -type f -name "test_$name")
  (cd "$copy" && XDG_CACHE_HOME="$build_folder/cache" timeout 300 "$program" --gtest_filter="$filter")
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
# Files that differ are copied, with the time of now: a fault that an earlier run left in an object is
# compiled away.
files=$(cd "$source_folder" && git ls-files --cached --others --exclude-standard | sort)
while read -r file; do
  if [ ! -f "$source_folder/$file" ] || cmp -s "$source_folder/$file" "$copy/$file"; then continue; fi
  mkdir -p "$copy/$(dirname "$file")"
  cp "$source_folder/$file" "$copy/$file" || fail "$file cannot be copied"
done <<<"$files"
(cd "$copy" && find . -type f | sed 's#^\./##' | sort) | comm -23 - <(echo "$files") | while read -r file; do
  rm -f "$copy/$file"
done
"$copy/tools/fetch_assets.sh" --cached >"$log" 2>&1 || echo "note: without the scan: $(cat "$log")"
# -O1, as the precompiled headers have it: these programs run for seconds and are compiled often.
quiet cmake -S "$copy" -B "$built" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"

# Without a fault the tests pass, else a failure would say nothing.
mapfile -t targets < <(for name in "${names[@]}"; do seen_by "$name"; done |
  sed 's/^\([^ ]*\) .*/test_\1/' | sort -u)
quiet build "${targets[@]}"
for name in "${names[@]}"; do quiet test_of "$name"; done

unseen=0
for name in "${names[@]}"; do
  patch=$here/$name.patch
  (cd "$copy" && patch --silent -p1 <"$patch") || fail "$name.patch does not fit the sources: write it anew"
  quiet build "test_$(seen_by "$name" | cut -d ' ' -f 1)"
  if test_of "$name" >"$log" 2>&1; then
    if grep -q 'SKIPPED' "$log"; then echo "skipped   $name: its test is, too"; else
      unseen=$((unseen + 1))
      echo "NOT SEEN  $name by $(seen_by "$name"): $(head -n 1 "$patch")"
    fi
  else
    echo "seen      $name by $(sed -nE 's/^\[  FAILED  \] ([^ ,]+) .*/\1/p' "$log" | head -n 1)"
  fi
  (cd "$copy" && patch --silent -R -p1 <"$patch")
done
# One in five may be the long tier's to see.
echo "${#names[@]} faults, $unseen not seen"
[ $((unseen * 5)) -le ${#names[@]} ]
