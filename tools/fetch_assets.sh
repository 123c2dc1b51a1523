#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puts the files of a list beside the manifests that use them. Each file is taken from
# $DERMIS_ASSET_CACHE/SET/NAME if it is there (else from ../shared/assets/SET/NAME), else downloaded; it
# appears under its name only when its length and its sha256 are those of the list. Files that are there and
# right are kept. The first problem ends the run: one line, exit status 1.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
list=$root/assets/heads/fetch.tsv
into=
set_name=lee-perry-smith
cached_only=false

usage() {
  cat <<'HELP'
usage: ./run fetch-assets [options]

  --cached     take files from the asset cache only, download nothing
  --list FILE  another list: tab-separated name, url, sha256, licence, bytes, below a header line
               (default assets/heads/fetch.tsv)
  --into DIR   where the files go (default: the folder of the list)
  --set NAME   folder within the asset cache (default lee-perry-smith)

The cache is $DERMIS_ASSET_CACHE, else ../shared/assets. URLs may be https, http or file.
HELP
}

fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

while [[ $# -gt 0 ]]; do
  case $1 in
    --cached) cached_only=true; shift ;;
    --list | --into | --set)
      [[ $# -ge 2 ]] || { echo "error: $1 needs a value" >&2; exit 2; }
      case $1 in --list) list=$2 ;; --into) into=$2 ;; --set) set_name=$2 ;; esac
      shift 2 ;;
    -h | --help) usage; exit 0 ;;
    *) echo "error: unknown option '$1'; known: --cached, --list, --into, --set, --help" >&2; exit 2 ;;
  esac
done
[[ -f $list && -r $list ]] || fail "$list: no such list"
into=${into:-$(dirname "$list")}
[[ -d $into && -w $into ]] || fail "$into: not a folder that can be written to"

part=
trap 'if [[ -n $part ]]; then rm -f -- "$part"; fi' EXIT
trap 'exit 130' INT TERM

size_of() { stat -L -c %s -- "$1"; }
hash_of() { sha256sum <"$1" | cut -d ' ' -f 1; }
is_right() { [[ -f $1 && $(size_of "$1") == "$bytes" && $(hash_of "$1") == "$sha256" ]]; }

# Prints the file's place in the cache, or nothing.
cached() {
  local folder
  for folder in "${DERMIS_ASSET_CACHE:-}" "$root/../shared/assets"; do
    if [[ -n $folder && -f $folder/$set_name/$name ]]; then echo "$folder/$set_name/$name"; return; fi
  done
}

# Downloads $url to $part; the status of curl decides which sentence is the helpful one.
download() {
  command -v curl >/dev/null || fail "$name: curl is not installed, so $url cannot be downloaded"
  local status=0
  curl --fail --location --silent --proto '=https,http,file' \
    --proto-redir '=https,http' --connect-timeout 20 --speed-limit 1 --speed-time 60 \
    --max-filesize "$bytes" --retry 2 --output "$part" -- "$url" || status=$?
  case $status in
    0) ;;
    5 | 6 | 7 | 28 | 35 | 52 | 55 | 56)
      fail "$name: no network: $url cannot be reached (curl status $status)" ;;
    18) fail "$name: short file: the transfer of $url broke off" ;;
    22 | 37 | 78) fail "$name: missing file: there is nothing at $url" ;;
    63) fail "$name: wrong length: $url holds more than the $bytes bytes of the list" ;;
    *) fail "$name: $url cannot be downloaded (curl status $status)" ;;
  esac
}

# Fetches one row: name, url, sha256, bytes are those of the loop below.
fetch() {
  local target=$into/$name from size
  if is_right "$target"; then kept=$((kept + 1)); return; fi
  part=$into/$name.$$.part
  from=$(cached)
  if [[ -n $from ]]; then
    cp -- "$from" "$part" || fail "$name: $from cannot be copied to $into"
  elif $cached_only; then
    fail "$name: not in the asset cache (DERMIS_ASSET_CACHE/$set_name), and nothing is downloaded"
  else
    from=$url
    download
  fi
  size=$(size_of "$part")
  [[ $size -ge $bytes ]] || fail "$name: short file: $from holds $size of $bytes bytes"
  [[ $size -eq $bytes ]] || fail "$name: wrong length: $from holds $size bytes, the list says $bytes"
  [[ $(hash_of "$part") == "$sha256" ]] ||
    fail "$name: wrong hash: the sha256 of $from is not that of the list"
  chmod 644 "$part"
  mv -f -- "$part" "$target"
  part=
  fetched=$((fetched + 1))
}

kept=0 fetched=0 row=0
while IFS=$'\t' read -r name url sha256 licence bytes rest || [[ -n ${name:-} ]]; do
  row=$((row + 1))
  if [[ $row -eq 1 ]]; then
    [[ "$name $url $sha256 $licence $bytes" == "name url sha256 licence bytes" ]] ||
      fail "$list: line 1: expected the header name, url, sha256, licence, bytes (tab-separated)"
    continue
  fi
  [[ $name =~ ^[A-Za-z0-9_][A-Za-z0-9._-]*$ ]] || fail "$list: line $row: '$name' is not a plain file name"
  [[ $url =~ ^(https|http|file):// ]] ||
    fail "$list: line $row: expected an https, http or file URL, got '$url'"
  [[ $sha256 =~ ^[0-9a-f]{64}$ ]] ||
    fail "$list: line $row: expected a sha256 of 64 hexadecimal digits, got '$sha256'"
  [[ -n $licence ]] || fail "$list: line $row: the licence is missing"
  [[ $bytes =~ ^[1-9][0-9]{0,9}$ && -z $rest ]] ||
    fail "$list: line $row: expected a length in bytes at the end, got '$bytes $rest'"
  fetch
done <"$list"
[[ $row -gt 1 ]] || fail "$list: names no files"
if [[ $fetched -gt 0 ]]; then
  echo "$fetched files put into $into, $kept were there; licences: $list"
fi
