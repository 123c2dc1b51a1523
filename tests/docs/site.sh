#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The pages that ./run docs makes: no link that leads nowhere, every page in the search, every command of the
# program, and a class of the API. Where mkdocs or doxygen is missing, only the page of the command line.
set -euo pipefail
source_folder=$1 dermis=$2/dermis
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$source_folder"

python3 tools/command_line_page.py "$dermis" "$place/page.md"
"$dermis" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p' >"$place/commands"
[ "$(wc -l <"$place/commands")" -ge 8 ] || { echo "the help lists no commands"; exit 1; }
while read -r command; do
  grep -qx "## $command" "$place/page.md" || { echo "the page has no section of $command"; exit 1; }
done <"$place/commands"
for option in --resume --each-optimisation --import --save-scene; do
  grep -q -- "\`$option\`" "$place/page.md" || { echo "the page lacks $option"; exit 1; }
done

for tool in mkdocs doxygen; do
  command -v "$tool" >/dev/null || { echo "skipped: there is no $tool (./run docs installs it)"; exit 0; }
done
tools/site/make.sh "$dermis" "$place/docs"
page=$place/docs/site/docs/command-line.html
grep -q 'id="render"' "$page" || { echo "no page of the command line"; exit 1; }
[ -s "$place/docs/site/api/classdermis_1_1Renderer.html" ] || { echo "the API lacks Renderer"; exit 1; }
