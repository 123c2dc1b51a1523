#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page of `dermis demo` with the head that is built in, and every command that it suggests, as it stands
# there.
set -euo pipefail
source_folder=$1 build_folder=$2
export XDG_CACHE_HOME=$build_folder/cache
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$source_folder"

fail() { echo "$1"; exit 1; }

"$build_folder/dermis" demo -o "$place" >"$place/log" 2>&1 || fail "demo failed: $(cat "$place/log")"
page=$place/demo.html
[ "$(grep -o '<img id=' "$page" | wc -l)" -eq 9 ] || fail "the page has not its nine pictures"
if grep -oE '(src|href)="http' "$page"; then fail "the page asks something of the network"; fi

tried=0
while read -r command; do
  bash -c "$command" >"$place/log" 2>&1 || fail "failed: $command: $(cat "$place/log")"
  tried=$((tried + 1))
done < <(sed -nE 's#.*<pre class="next">(.*)</pre>.*#\1#p' "$page" |
  sed -e 's/&amp;/\&/g' -e 's/&lt;/</g' -e 's/&gt;/>/g' -e "s/&#39;/'/g" -e 's/&quot;/"/g')
[ "$tried" -ge 5 ] || fail "the page suggests $tried commands"
for file in studio.png difference.html skin1.png turn.png; do
  [ -s "$place/$file" ] || fail "$file was not written"
done
echo "$tried commands work as they stand on the page"
