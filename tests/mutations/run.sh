#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh SOURCE BUILD [NAME...]   Builds a copy of the sources with one fault at a time, NAME.patch beside
# this file, and runs the tests that its line "Seen by:" names: one of them has to fail. Without NAME: every
# fault. The copy and its build are kept in BUILD/mutants, so that a second run compiles little.
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
seen_by() { sed -n 's/^Seen by: //p' "$here/$1.patch"; }
build() {
  local target targets=()
  for target in "$@"; do targets+=("test_${target%_short}"); done
  cmake --build "$built" --parallel "${DERMIS_JOBS:-$(nproc)}" --target "${targets[@]}"
}
tests() {
  local IFS='|'
  ctest --test-dir "$built" --no-tests=error --output-on-failure --parallel "$(nproc)" -R "^($*)$"
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
rm -rf "$copy"
mkdir -p "$copy"
(cd "$source_folder" && git ls-files -z --cached --others --exclude-standard |
  xargs -0 ls -d 2>/dev/null | tar -cf - -T -) | tar -xf - -C "$copy" || fail "the sources cannot be copied"
# -O1: these programs run for seconds and are compiled often.
quiet cmake -S "$copy" -B "$built" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"

# Without a fault they pass, else a failure would say nothing.
read -ra all < <(for name in "${names[@]}"; do seen_by "$name"; done | tr ' ' '\n' | sort -u | tr '\n' ' ')
quiet build "${all[@]}"
quiet tests "${all[@]}"

unseen=0
for name in "${names[@]}"; do
  patch=$here/$name.patch
  read -ra entries < <(seen_by "$name")
  (cd "$copy" && patch --silent -p1 <"$patch") || fail "$name.patch does not fit the sources: write it anew"
  quiet build "${entries[@]}"
  if tests "${entries[@]}" >"$log" 2>&1; then
    unseen=$((unseen + 1))
    echo "NOT SEEN  $name (${entries[*]}): $(head -n 1 "$patch")"
  else
    echo "seen      $name: $(sed -nE 's/.*(Failed|FAILED *)\] +([A-Za-z]+[^ ,]*).*/\2/p' "$log" | head -n 1)"
  fi
  (cd "$copy" && patch --silent -R -p1 <"$patch")
done
echo "${#names[@]} faults, $unseen not seen"
[ "$unseen" -eq 0 ]
