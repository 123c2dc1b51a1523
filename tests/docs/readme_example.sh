#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Code that is only shown rots. Blocks of README.md between "<!-- file: PATH -->" and "<!-- end -->" are those
# files, letter by letter; blocks of docs/*.md after "<!-- from: PATH -->" stand in those files.
set -euo pipefail
source_folder=$1
shown=0
while read -r path; do
  block=$(awk -v start="<!-- file: $path -->" '
    $0 == start {on = 1; next}
    on && $0 == "<!-- end -->" {exit}
    on && !/^```/' "$source_folder/README.md")
  if [ "$block" != "$(cat "$source_folder/$path")" ]; then
    echo "README.md shows $path as it is not; the difference (README.md first):"
    diff <(printf '%s\n' "$block") "$source_folder/$path" || true
    exit 1
  fi
  shown=$((shown + 1))
done < <(sed -n 's/^<!-- file: \(.*\) -->$/\1/p' "$source_folder/README.md")
if [ "$shown" -lt 2 ]; then
  echo "README.md shows $shown files between markers; the example and its CMakeLists.txt should be there"
  exit 1
fi

excerpts=0
for document in "$source_folder"/docs/*.md; do
  while read -r line path; do
    block=$(tail -n "+$((line + 2))" "$document" | sed '/^```/,$d')
    if [[ -z $block || $(cat "$source_folder/$path") != *"$block"* ]]; then
      echo "$document:$line shows what does not stand in $path:"
      printf '%s\n' "$block"
      exit 1
    fi
    excerpts=$((excerpts + 1))
  done < <(sed -n '/^<!-- from: .* -->$/{=;s/^<!-- from: \(.*\) -->$/\1/p}' "$document" | paste - -)
done
if [ "$excerpts" -lt 2 ]; then
  echo "the documents show $excerpts excerpts; those of the tutorial of an engine should be there"
  exit 1
fi
echo "README.md shows $shown files as they are, the documents $excerpts excerpts"
