#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The figures of README.md are those of the records, and it is short. A figure that was changed by hand, a
# record that was changed or is missing, is noticed.
source "$(dirname "$0")/../tools/expect.sh"

copy() {
  rm -rf "$scratch/copy"
  mkdir -p "$scratch/copy/docs" "$scratch/copy/tools"
  cp "$root/README.md" "$scratch/copy"
  cp "$root/tools/readme_figures.py" "$scratch/copy/tools"
  cp -r "$root/docs/results" "$scratch/copy/docs"
}
made() { call python3 "$scratch/copy/tools/readme_figures.py" "$@"; }
h100=docs/results/nvidia-h100.json

call python3 "$root/tools/readme_figures.py" --check
check "README.md says what the records say; tools/readme_figures.py writes it" status_is 0
words=$(wc -w <"$root/README.md")
check "README.md has at most 1500 words, not $words" test "$words" -le 1500

copy
sed -i '/^| `separable`/s/[0-9.]* |$/0.01 |/' "$scratch/copy/README.md"
made --check
check "a figure that was changed by hand" status_is 1
check "it is shown" says "-| \`separable\`"
copy
sed -i '0,/"separable_ms": [0-9.]*/s//"separable_ms": 9.87/' "$scratch/copy/$h100"
made --check
check "a record that was changed" status_is 1
made
check "changes the table" grep -q '^| `separable`.* 9.87 |$' "$scratch/copy/README.md"
rm "$scratch/copy/$h100"
made --check
check "a record that is missing" status_is 1
check "is named" says "nvidia-h100.json"
finish
