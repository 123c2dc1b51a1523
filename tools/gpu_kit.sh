#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# gpu_kit.sh make   Packs the program, its measurements and heads into one archive for a machine with a GPU
# and nothing else: docs/methodology.md. The archive appears under its name only when complete. The first
# problem ends the run: one line, exit status 1.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
archive=$root/out/dermis-kit-$(uname -m).tar.gz
most_bytes=60000000
do_build=true

usage() {
  cat <<'HELP'
usage: tools/gpu_kit.sh make [options]

  -o FILE      the archive (default out/dermis-kit-MACHINE.tar.gz)
  --build DIR  where dermis is built (default build/release)
  --no-build   pack what is there, build nothing

The scan is packed if its files are in assets/heads or in the asset cache, three heads if they are in the
asset cache: $DERMIS_ASSET_CACHE, else ../shared/assets. What is not there is a note; the built-in head is a
part of the program.
HELP
}

fail() { printf 'error: %s\n' "$*" >&2; exit 1; }
note() { printf 'note: %s\n' "$*" >&2; }

[[ $# -gt 0 ]] || { usage >&2; exit 2; }
case $1 in
  make) shift ;;
  -h | --help | help) usage; exit 0 ;;
  *) echo "error: unknown command '$1'; known: make, help" >&2; exit 2 ;;
esac
while [[ $# -gt 0 ]]; do
  case $1 in
    -o | --build)
      [[ $# -ge 2 ]] || { echo "error: $1 needs a value" >&2; exit 2; }
      case $1 in -o) archive=$2 ;; --build) build=$2 ;; esac
      shift 2 ;;
    --no-build) do_build=false; shift ;;
    -h | --help) usage; exit 0 ;;
    *) echo "error: unknown option '$1'; known: -o, --build, --no-build, --help" >&2; exit 2 ;;
  esac
done
[[ -d $build ]] || fail "$build: no such folder; ./run build makes it"
if [[ $archive == "$root"/out/* ]]; then mkdir -p "$root/out"; fi
[[ -d $(dirname "$archive") && -w $(dirname "$archive") ]] ||
  fail "$(dirname "$archive"): not a folder that can be written to"

part=
stage=$(mktemp -d)
trap 'rm -rf -- "$stage"; if [[ -n $part ]]; then rm -f -- "$part"; fi' EXIT
trap 'exit 130' INT TERM
kit=$stage/dermis-kit
mkdir -p "$kit"/{bin,lib,licences,assets} "$kit"/share/vulkan/{icd.d,explicit_layer.d}

# put FILE TO: a copy that is readable by all, links resolved
put() { install -D -m 644 -- "$1" "$2" || fail "$1 cannot be copied to the kit; is there room in $stage?"; }

# Where a library lies that is opened by name, or nothing.
# Reads the list to its end: ldconfig must not be stopped by a pipe that nobody reads, which ends the script.
find_library() {
  { ldconfig -p 2>/dev/null || /sbin/ldconfig -p; } |
    awk -v name="$1" '$1 == name && /x86-64|AArch64/ && !found { found = $NF }
      END { print found }'
}

# Is part of the C library, which every system has.
is_c_library() {
  [[ $1 =~ ^(ld-linux.*|libc|libm|libdl|librt|libpthread|libresolv|libutil|libmvec)\.so\.[0-9]+$ ]]
}

# A driver may need these, too, in its own version: each has a folder, and run_kit decides.
folder_of() {
  case $1 in
    libstdc++.so.*) echo lib/libstdc++ ;;
    libgcc_s.so.*) echo lib/libgcc ;;
    libz.so.*) echo lib/libz ;;
    *) echo "$2" ;;
  esac
}

# pack_libraries FOLDER FILE...: what those files need, each once
pack_libraries() {
  local folder=$1 name path
  shift
  while read -r name path; do
    [[ $path != not ]] || fail "$name is not found; it is needed by one of: $*"
    is_c_library "$name" && continue
    pack_library "$name" "$path" "$(folder_of "$name" "$folder")"
  done < <(for file in "$@"; do ldd "$file" | awk '$2 == "=>" { print $1, $3 }'; done | sort -u)
}

pack_library() {
  [[ -z $(find "$kit/lib" -name "$1") ]] || return 0
  put "$2" "$kit/$3/$1"
  readlink -f -- "$2" >>"$stage/packed"
}

pack_programs() {
  local name from
  for name in run_kit:apps/kit/run_kit bin/kit:apps/kit/kit bin/dermis:dermis \
    bin/kit_checks:tests/kit/kit_checks bin/sessions_bench:bench/sessions/sessions_bench; do
    from=$build/${name#*:}
    [[ -x $from ]] || fail "$from is not there; without --no-build it is built"
    put "$from" "$kit/${name%%:*}"
    chmod 755 "$kit/${name%%:*}"
    strip "$kit/${name%%:*}"
  done
  pack_libraries lib "$kit"/bin/* "$kit/run_kit"
}

# The loader is opened by name. What NVIDIA's driver needs is not on every machine that has one.
pack_vulkan() {
  local path name
  path=$(find_library libvulkan.so.1)
  [[ -n $path ]] || fail "libvulkan.so.1, the loader, is not here (Debian, Ubuntu: apt install libvulkan1)"
  pack_library libvulkan.so.1 "$path" lib
  pack_libraries lib "$path"
  for name in libX11.so.6 libXext.so.6 libEGL.so.1; do
    path=$(find_library "$name")
    [[ -n $path ]] || { note "$name is not here and not packed: NVIDIA's driver needs it"; continue; }
    pack_library "$name" "$path" lib/desktop
    pack_libraries lib/desktop "$path"
  done
  cat >"$kit/share/vulkan/icd.d/nvidia.json" <<'JSON'
{"file_format_version": "1.0.0", "ICD": {"library_path": "libGLX_nvidia.so.0", "api_version": "1.3.0"}}
JSON
}

pack_validation_layer() {
  local library=libVkLayer_khronos_validation.so manifest path
  manifest=/usr/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json
  path=$(find /usr/lib /usr/lib64 -name "$library" -print -quit 2>/dev/null || true)
  if [[ ! -r $manifest || -z $path ]]; then
    note "the validation layer is not here and not packed (apt install vulkan-validationlayers)"
    rmdir "$kit/share/vulkan/explicit_layer.d"
    return
  fi
  pack_library "$library" "$path" lib/layers
  pack_libraries lib "$path"
  sed "s|\"library_path\": *\"[^\"]*\"|\"library_path\": \"../../../lib/layers/$library\"|" "$manifest" \
    >"$kit/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json"
}

pack_scan() {
  local into=$kit/assets/heads name
  mkdir "$into"
  while IFS=$'\t' read -r name _; do
    if [[ -f $root/assets/heads/$name ]]; then put "$root/assets/heads/$name" "$into/$name"; fi
  done < <(tail -n +2 "$root/assets/heads/fetch.tsv")
  if ! "$root/tools/fetch_assets.sh" --cached --list "$root/assets/heads/fetch.tsv" --into "$into" \
    >"$stage/said" 2>&1; then
    note "the scan is not packed: $(sed 's/^error: //' "$stage/said")"
    rm -r "$into"
    return
  fi
  for name in "$root"/assets/heads/lee-perry-smith*.gltf; do put "$name" "$into/$(basename "$name")"; done
  cat >"$kit/licences/lee-perry-smith.txt" <<'TEXT'
assets/heads: "Infinite, 3D Head Scan" by Lee Perry-Smith (Infinite-Realities, www.ir-ltd.net), CC BY 3.0
(https://creativecommons.org/licenses/by/3.0/), based on a work at www.triplegangers.com. The manifests scale
it to metres and add a material, cameras and lights.
TEXT
}

pack_people() {
  local cache=${DERMIS_ASSET_CACHE:-$root/../shared/assets}/makehuman name
  for name in mh-african-man-young mh-asian-woman-young mh-european-man-young; do
    if [[ ! -f $cache/$name.glb || ! -f $cache/LICENSE-CC0.txt ]]; then
      note "three heads are not packed: makehuman/$name.glb and its licence are not in the asset cache"
      rm -rf "$kit/assets/makehuman"
      return
    fi
    put "$cache/$name.glb" "$kit/assets/makehuman/$name.glb"
  done
  put "$cache/LICENSE-CC0.txt" "$kit/licences/makehuman.txt"
  if [[ -f $cache/NOTICE.txt ]]; then put "$cache/NOTICE.txt" "$kit/licences/makehuman-notice.txt"; fi
}

# package_of FILE: the package that a library came with. Its path there may lack /usr.
package_of() {
  { dpkg-query -S "$1" 2>/dev/null || dpkg-query -S "${1#/usr}" 2>/dev/null || true; } |
    sed -n '1s/[:,].*//p'
}

# Of everything that is packed or compiled in, and the texts that those refer to.
pack_licences() {
  local file package text
  put "$root/LICENSE" "$kit/licences/dermis.txt"
  {
    while read -r file; do
      package=$(package_of "$file")
      [[ -n $package ]] || fail "$file: the package it came with is not known, so its licence is not"
      echo "$package"
    done <"$stage/packed"
    printf '%s\n' libcli11-dev nlohmann-json3-dev libglm-dev libeigen3-dev libgtest-dev libvulkan-dev
  } | sort -u >"$stage/packages" || exit 1
  while read -r package; do
    text=/usr/share/doc/$package/copyright
    [[ -r $text ]] || fail "$text is not there: a kit without the licence of $package is not made"
    put "$text" "$kit/licences/$package.txt"
  done <"$stage/packages"
  while read -r text; do
    if [[ -r $text ]]; then put "$text" "$kit/licences/common/$(basename "$text")"; fi
  done < <(grep -ohE '/usr/share/common-licenses/[A-Za-z0-9.+-]*[A-Za-z0-9]' "$kit"/licences/*.txt | sort -u)
}

# newest_c_library FILE...: the newest version of a symbol of the C library that they need
newest_c_library() { objdump -T "$@" | grep -oE 'GLIBC_[0-9.]+' | sort -Vu | tail -n 1 | sed 's/GLIBC_//'; }

write_readme() {
  local needs needs_fallback
  needs=$(newest_c_library "$kit"/run_kit "$kit"/bin/* "$kit"/lib/*.so*)
  needs_fallback=$(newest_c_library "$kit"/lib/libstdc++/* "$kit"/lib/libgcc/* "$kit"/lib/libz/*)
  cat >"$kit/README.txt" <<TEXT
dermis, packed for a machine with a GPU and its Vulkan driver, and nothing else installed. $(uname -m), Linux.
It needs a C library of version $needs, or of $needs_fallback where the system has no libstdc++ of its own.

  ./run_kit --quick     a first look; writes kit-results/kit-DEVICE.json and .html
  ./run_kit             everything, at the size of the published test
  ./run_kit --help      all options
  ./run_kit dermis ...  the program itself

No file outside the folder of the results is written, and nothing is asked of the network. licences/ holds the
licence of everything in here.
TEXT
  c_library=$needs
}

if $do_build; then
  cmake --build "$build" --target dermis kit run_kit kit_checks sessions_bench >"$stage/log" 2>&1 ||
    { tail -n 15 "$stage/log" >&2; fail "the build in $build failed (see the lines above)"; }
fi
pack_programs
pack_vulkan
pack_validation_layer
pack_scan
pack_people
pack_licences
write_readme

part=$archive.$$.part
when=$(git -C "$root" log -1 --format=%ct 2>/dev/null || echo 0)
tar --sort=name --mtime="@$when" --owner=0 --group=0 --numeric-owner -C "$stage" -cf - dermis-kit |
  gzip -n >"$part" || fail "$archive cannot be written"
bytes=$(stat -c %s "$part")
[[ $bytes -lt $most_bytes ]] || fail "the archive has $bytes bytes, the limit is $most_bytes"
chmod 644 "$part"
mv -f -- "$part" "$archive"
part=
printf '%s: %d bytes, needs a C library of %s or newer\n' "$archive" "$bytes" "$c_library"
