#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# install_packages.sh LIST [SECTION...] | -- NAME...   Installs those packages of the list that are missing,
# of all its sections or of those named, and does nothing at all when none is: no package index is read, no
# password asked. Exit status 1, with one line that says what to do, when they cannot be installed.
set -euo pipefail
export LC_ALL=C

fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

if [[ ${1:-} == -- ]]; then
  wanted=("${@:2}")
else
  [[ -r ${1:-} ]] || fail "package list '${1:-}' cannot be read"
  mapfile -t wanted < <(awk -v sections=" ${*:2} " '
    { sub(/#.*/, ""); gsub(/[[:space:]]/, "") }
    /^\[.*\]$/ { here = " " substr($0, 2, length($0) - 2) " "; next }
    $0 != "" && (sections ~ /^ *$/ || index(sections, here))' "$1")
  [[ ${#wanted[@]} -gt 0 ]] || fail "package list '$1' has nothing in: ${*:2}"
fi

if ! command -v dpkg-query >/dev/null; then
  echo "note: not a Debian or Ubuntu system; please install what ${1} lists with your own package manager" >&2
  exit 0
fi

# dpkg-query fails when one name is unknown to it, and still prints the others: absent from its output =
# missing.
installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null |
  sed -n 's/ installed$//p' || true)
missing=()
for name in "${wanted[@]}"; do
  grep -qxF -- "$name" <<<"$installed" || missing+=("$name")
done
if [[ ${#missing[@]} -eq 0 ]]; then exit 0; fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null ||
    fail "these packages are missing and there is no sudo; as root run: apt-get install ${missing[*]}"
  as_root=(sudo)
fi
echo "installing ${#missing[@]} missing packages: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" \
    >"$log" 2>&1; then
    tail -n 15 "$log" >&2
    return 1
  fi
}
# An index that cannot be refreshed may still be good enough to install from: the install decides.
apt update || echo "note: apt-get update failed; trying with the package index there is" >&2
apt install -y --no-install-recommends "${missing[@]}" ||
  fail "apt-get could not install: ${missing[*]} (see the lines above: network, sources, or a release older" \
    "than Debian 12 / Ubuntu 24.04)"
