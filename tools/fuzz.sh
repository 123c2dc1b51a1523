#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fuzzes every reader of tests/fuzz for HOURS in all: seeds from tests/fuzz/seeds and the asset cache, a
# corpus that grows from run to run and is minimised at the end, a table of executions, coverage and findings.
# Exit status 1 if anything was found.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/fuzz
jobs=${DERMIS_JOBS:-$(nproc)}
seconds=
hours=
wanted=()

# What an input may take. More is a finding: limits are checked before memory is taken, and nothing hangs.
limits=(-rss_limit_mb=2048 -malloc_limit_mb=2048 -timeout=10)
most_findings=10  # of a target in one run; then it is left alone

usage() {
  cat <<'HELP'
usage: tools/fuzz.sh HOURS [TARGET...]
       tools/fuzz.sh --seconds N [TARGET...]

  HOURS        of the whole run, shared out evenly over the targets (a fraction will do: 0.5)
  --seconds N  of each target instead
  TARGET       names of tests/fuzz/CMakeLists.txt; default all

Needs the programs of preset fuzz: ./run fuzz builds them (and fuzzes for a minute each).

  build/fuzz/corpus/TARGET    what has been found to reach new code; kept, and minimised at the end
  build/fuzz/findings/TARGET  inputs that broke something
  build/fuzz/logs/TARGET.log  what the fuzzer said

environment
  DERMIS_JOBS         targets side by side (default: one per processor)
  DERMIS_ASSET_CACHE  folder whose files are seeds, too (default ../shared/assets; none is no error)
HELP
}

fail() { printf 'error: %s\n' "$1" >&2; exit "${2:-1}"; }
refuse() { fail "$1" 2; }

while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --seconds) seconds=${2:-}; shift 2 || fail "--seconds needs a value" ;;
    -*) echo "error: unknown option '$1'; known: --seconds, --help" >&2; exit 2 ;;
    *) if [[ -z $seconds && -z $hours ]]; then hours=$1; else wanted+=("$1"); fi; shift ;;
  esac
done
[[ -n $seconds || -n $hours ]] || { usage >&2; exit 2; }
[[ ${seconds:-1} =~ ^[1-9][0-9]{0,6}$ ]] || refuse "--seconds must be a whole number from 1, got '$seconds'"
[[ ${hours:-1} =~ ^[0-9]{1,4}(\.[0-9]+)?$ ]] || refuse "HOURS must be a number, got '$hours'"
[[ -f $build/fuzz/targets.tsv ]] || fail "there are no fuzz targets yet: ./run fuzz builds them"

declare -A max_bytes dictionary
targets=()
while read -r name bytes dict; do
  targets+=("$name") max_bytes[$name]=$bytes dictionary[$name]=$dict
done <"$build/fuzz/targets.tsv"
for name in "${wanted[@]}"; do
  [[ -n ${max_bytes[$name]:-} ]] || fail "no target is called '$name'; there are: ${targets[*]}"
done
[[ ${#wanted[@]} -eq 0 ]] || targets=("${wanted[@]}")
if [[ -z $seconds ]]; then
  seconds=$(awk -v h="$hours" -v j="$jobs" -v n="${#targets[@]}" \
    'BEGIN { s = int(h * 3600 * (j < n ? j : n) / n); print s < 1 ? 1 : s }')
fi

# Inputs are files for a moment: in memory if there is such a place.
scratch=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d)
touch "$scratch/started"
set -m  # each target is a process group, so that none outlives this script
stop() {
  local group
  for group in $(jobs -p); do kill -- "-$group" 2>/dev/null || true; done
  wait
  rm -rf "$scratch"
}
trap stop EXIT
trap 'exit 130' INT TERM
export TMPDIR=$scratch
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=1:allocator_may_return_null=0}"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1}"

python3 "$root/tools/fuzz_seeds.py" "$build/fuzz/targets.tsv" "$root/tests/fuzz/seeds" \
  "${DERMIS_ASSET_CACHE:-$root/../shared/assets}" "$build/seeds"

stat_of() { sed -n "s/^stat::$1: *//p" "$2" | awk '{ sum += $1 } END { print sum + 0 }'; }
count_files() { find "$1" -type f 2>/dev/null | wc -l; }

# Runs one target until its time is up; an input that breaks it is kept, and the rest of the time goes on
# without it.
fuzz() {
  local name=$1 log=$build/logs/$1.log end=$((SECONDS + seconds)) found=0 before options
  mkdir -p "$build/corpus/$name" "$build/findings/$name" "$scratch/$name"
  options=("${limits[@]}" -max_len="${max_bytes[$name]}" -artifact_prefix="$build/findings/$name/"
    -print_final_stats=1)
  [[ ${dictionary[$name]} == - ]] ||
    options+=(-dict="$root/tests/fuzz/dictionaries/${dictionary[$name]}.dict")
  : >"$log"
  while [[ $SECONDS -lt $end && $found -lt $most_findings ]]; do
    before=$(count_files "$build/findings/$name")
    TMPDIR=$scratch/$name "$build/fuzz/fuzz_$name" "${options[@]}" -max_total_time=$((end - SECONDS)) \
      "$build/corpus/$name" "$build/seeds/$name" >>"$log" 2>&1 && break
    found=$((found + 1))
    # The same input again stands at the beginning of the corpus: the time that is left would not get past it.
    [[ $(count_files "$build/findings/$name") -gt $before ]] || break
  done
  printf '%s\n' "$found" >"$scratch/$name.findings"
  minimise "$name"
}

# Keeps of corpus and seeds only what reaches something that nothing smaller reaches. An input that no longer
# passes is left behind.
minimise() {
  local name=$1 small=$scratch/$1.small
  mkdir -p "$small"
  if TMPDIR=$scratch/$name "$build/fuzz/fuzz_$name" "${limits[@]}" -max_len="${max_bytes[$name]}" \
    -artifact_prefix="$scratch/$name/" -merge=1 "$small" "$build/corpus/$name" "$build/seeds/$name" \
    >"$build/logs/$name.merge.log" 2>&1; then
    rm -rf "$build/corpus/$name"
    mv "$small" "$build/corpus/$name"
  fi
}

mkdir -p "$build/logs"
echo "fuzzing ${#targets[@]} targets for $seconds s each, $jobs at a time: ${targets[*]}"
for name in "${targets[@]}"; do
  while [[ $(jobs -rp | wc -l) -ge $jobs ]]; do wait -n || true; done
  fuzz "$name" &
done
wait

printf '\n%-18s %10s %12s %9s %8s %9s\n' target seconds executions edges corpus findings
found=0
for name in "${targets[@]}"; do
  log=$build/logs/$name.log
  executions=$(stat_of number_of_executed_units "$log")
  edges=$(grep -oE 'cov: [0-9]+' "$log" | awk '$2 > most { most = $2 } END { print most + 0 }')
  findings=$(cat "$scratch/$name.findings")
  printf '%-18s %10d %12d %9d %8d %9d\n' "$name" "$seconds" "$executions" "$edges" \
    "$(count_files "$build/corpus/$name")" "$findings"
  found=$((found + findings))
done
if [[ $found -gt 0 ]]; then
  printf '\n%d findings. What each did is in build/fuzz/logs/TARGET.log; to see one again:\n' "$found" >&2
  for name in "${targets[@]}"; do
    find "$build/findings/$name" -type f -newer "$scratch/started" \
      -printf "  build/fuzz/fuzz/fuzz_$name %p\n" >&2
  done
  exit 1
fi
