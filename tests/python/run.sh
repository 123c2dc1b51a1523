#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh SOURCES BUILD: pytest of python/tests, which runs mypy too.
set -euo pipefail
source_folder=$1 build=$2

status=0
packages=(pytest mypy pyelftools pillow tqdm OpenEXR flip-evaluator matplotlib)
python=$("$source_folder/tools/python_module.sh" "$build" "$build/python" "${packages[@]}") || status=$?
[[ $status == 0 ]] || exit "$status"
export DERMIS_PROGRAM=$build/dermis
# In the folder of the tests: beside python/dermis, that would be the module.
cd "$source_folder/python/tests"
"$python" -m pytest -q -p no:cacheprovider
