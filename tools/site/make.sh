#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# make.sh DERMIS OUT   Makes OUT/site: the documents as pages with search, every option of the program DERMIS,
# and the API reference of the public headers. Needs mkdocs and doxygen. A link that leads nowhere is an
# error.
set -euo pipefail
dermis=$(realpath "$1") out=$2
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mkdir -p "$out"
out=$(realpath "$out")
rm -rf "$out/sources" "$out/site"
mkdir -p "$out/sources"

# The pages lie as in the tree, so that their links hold; what they link to beside pages comes along.
{
  find . -name '*.md' -not -path './build/*' -not -path './out/*' -not -path './.*'
  find docs include -type f
  echo LICENSE
  echo tools/packages.txt
} | while read -r file; do
  mkdir -p "$out/sources/$(dirname "$file")"
  cp "$file" "$out/sources/$file"
done
mv "$out/sources/README.md" "$out/sources/index.md"
python3 tools/command_line_page.py "$dermis" "$out/sources/docs/command-line.md"
cat >"$out/sources/api.md" <<'END'
# API reference

<a href="api/index.html">Of the public headers</a>, made by Doxygen.
END
python3 tools/site/rewrite_links.py "$out/sources"

cp tools/site/mkdocs.yml "$out/mkdocs.yml"
mkdocs --quiet build --strict --config-file "$out/mkdocs.yml"
rm "$out/site/404.html"  # its links are those of a server's root
(cat tools/site/Doxyfile; echo "OUTPUT_DIRECTORY = $out/site") | doxygen -
python3 tools/site/check_pages.py "$out/site"
echo "$out/site/index.html"
