# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the script tests: a temporary folder that goes away, and expectations that count.
set -uo pipefail
root=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0 checks=0

# check SENTENCE COMMAND...: the command must succeed
check() {
  checks=$((checks + 1))
  if ! "${@:2}"; then
    failures=$((failures + 1))
    printf 'FAILED: %s\n  got: %s\n' "$1" "$(cat "$scratch/output" 2>/dev/null)"
  fi
}

# call COMMAND...: leaves its status in $status and everything it printed in $scratch/output
call() {
  status=0
  "$@" >"$scratch/output" 2>&1 || status=$?
}

status_is() { [[ $status -eq $1 ]]; }
says() { grep -qF -- "$1" "$scratch/output"; }
says_one_line() { [[ $(wc -l <"$scratch/output") -eq 1 ]]; }
says_nothing() { [[ ! -s $scratch/output ]]; }

finish() {
  printf '%d checks, %d failed\n' "$checks" "$failures"
  [[ $checks -gt 0 && $failures -eq 0 ]]
  exit
}
