#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# validation_layer.sh [--cached]: prints a folder for VK_LAYER_PATH with a validation layer of today, which
# finds hazards that the packaged one, of early 2023 on Debian 12, misses. It is the one that Debian's
# chromium-common holds: where that is not installed, its package (32 MB) is downloaded and unpacked, nothing
# is installed; --cached: nothing is downloaded either. Exit status 1, with a line that says why, where there
# is none.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { printf 'error: no validation layer of today: %s\n' "$*" >&2; exit 1; }

folder=$PWD/build/validation-layer library=libVkLayer_khronos_validation.so
found=/usr/lib/chromium/$library
if [[ ! -e $found ]]; then
  found=$folder/$library
  if [[ ! -e $found ]]; then
    [[ ${1:-} != --cached ]] || fail "chromium-common is not installed; tools/validation_layer.sh gets it"
    command -v apt-get >/dev/null || fail "it comes from Debian's chromium-common, and here is no apt-get"
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    (cd "$scratch" && timeout 120 apt-get -qq download chromium-common >/dev/null 2>&1) ||
      fail "chromium-common cannot be downloaded"
    dpkg-deb -x "$scratch"/chromium-common_*.deb "$scratch/unpacked"
    [[ -e $scratch/unpacked/usr/lib/chromium/$library ]] || fail "this chromium-common has none"
    mkdir -p "$folder"
    mv "$scratch/unpacked/usr/lib/chromium/$library" "$found.part"
    mv "$found.part" "$found"
  fi
fi

manifest=VkLayer_khronos_validation.json
packaged=/usr/share/vulkan/explicit_layer.d/$manifest
[[ -e $packaged ]] || fail "its manifest comes from vulkan-validationlayers, which is not installed"
mkdir -p "$folder"
sed "s#\"library_path\": \".*\"#\"library_path\": \"$found\"#" "$packaged" >"$folder/$manifest"
echo "$folder"
