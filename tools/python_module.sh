#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# python_module.sh BUILD FOLDER [PACKAGE...]: makes a virtual environment of the system's Python in
# FOLDER/venv, installs the module there against the library of the build folder, and these packages, and
# prints its interpreter. Exit status 77, with a line that says why, where the system has no venv or no
# headers of Python, or where what pip needs cannot be downloaded.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1 folder=$2
skip() { printf 'skipped: %s\n' "$*" >&2; exit 77; }

system=/usr/bin/python3
"$system" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null ||
  skip "$system is not there, or older than 3.11"
"$system" -c 'import ensurepip, venv' 2>/dev/null || skip "$system has no venv: apt-get install python3-venv"
headers=$("$system" -c 'import sysconfig; print(sysconfig.get_path("include"))')
[[ -e $headers/Python.h ]] || skip "$headers/Python.h is not there: apt-get install python3-dev"

mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cmake --install "$build" --component development --prefix "$folder/prefix" >"$folder/install.log"
config=$(dirname "$(find "$folder/prefix" -name dermisConfig.cmake)")
[[ -x $folder/venv/bin/python ]] || "$system" -m venv "$folder/venv"
pip=("$folder/venv/bin/python" -m pip --disable-pip-version-check --quiet)
timeout 300 "${pip[@]}" install scikit-build-core nanobind numpy "${@:3}" >"$folder/pip.log" 2>&1 ||
  skip "pip cannot download what the module is built with; $folder/pip.log says more"

# Built again each time, with what the compiler has kept: pip knows no other way to find out what has changed.
"${pip[@]}" install --no-build-isolation --no-deps --force-reinstall \
  --config-settings=cmake.define.dermis_DIR="$config" --config-settings=build-dir="$folder/build" \
  ./python >"$folder/pip.log" 2>&1 || { cat "$folder/pip.log" >&2; exit 1; }
echo "$folder/venv/bin/python"
