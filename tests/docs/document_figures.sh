#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The figures of the documents are those of the records, and README.md is short. A figure that was changed by
# hand, a record that was changed or is missing, a table that no document shows, is noticed.
source "$(dirname "$0")/../tools/expect.sh"

copy() {
  rm -rf "$scratch/copy"
  mkdir -p "$scratch/copy/tools"
  cp "$root/README.md" "$scratch/copy"
  cp "$root/tools/document_figures.py" "$scratch/copy/tools"
  cp -r "$root/docs" "$scratch/copy"
}
made() { call python3 "$scratch/copy/tools/document_figures.py" "$@"; }
h100=docs/results/nvidia-h100.json

call python3 "$root/tools/document_figures.py" --check
check "the documents say what the records say; tools/document_figures.py writes it" status_is 0
words=$(wc -w <"$root/README.md")
check "README.md has at most 1500 words, not $words" test "$words" -le 1500

copy
sed -i '/^| `separable`/s/[0-9.]* |$/0.01 |/' "$scratch/copy/README.md"
made --check
check "a figure that was changed by hand" status_is 1
check "it is shown" says "-| \`separable\`"
copy
sed -i '/^| 16 |/s/(2.01)/(2.02)/' "$scratch/copy/docs/performance.md"
made --check
check "a figure of another page that was changed by hand" status_is 1
check "its page is named" says "performance.md"
copy
sed -i '0,/"separable_ms": [0-9.]*/s//"separable_ms": 9.87/' "$scratch/copy/$h100"
made --check
check "a record that was changed" status_is 1
made
check "changes the table" grep -q '^| `separable`.* 9.87 |$' "$scratch/copy/README.md"
copy
sed -i 's/<!-- figures: suns -->/<!-- suns -->/' "$scratch/copy/docs/accuracy.md"
made --check
check "a table that no document shows" says "no document shows: suns"
rm "$scratch/copy/$h100"
made --check
check "a record that is missing" status_is 1
check "is named" says "nvidia-h100.json"
finish
