#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""rewrite_links.py FOLDER   In the pages below FOLDER: links to README.md of the root lead to index.md, links
to folders to the list of their files, and links to the public headers to the API reference."""
import os
import pathlib
import re
import sys

LINK = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(\))")


def target_of(page, link, root):
    """What the link leads to on the site; the link as it is where that stays."""
    if re.match(r"[a-z]+:", link):
        return link
    path = pathlib.Path(os.path.normpath(page.parent / link))
    beside = page.parent
    if path == root / "README.md":
        path = root / "index.md"
    elif path.is_relative_to(root / "include"):
        path = root / "api.md"
    elif path.is_dir():
        listing = path / "files.md"
        if not listing.exists():
            names = sorted(p.name for p in path.iterdir() if p.is_file() and p.suffix != ".md")
            lines = [f"- [{name}]({name})" for name in names]
            listing.write_text(f"# {path.relative_to(root)}\n\n" + "\n".join(lines) + "\n", encoding="utf-8")
        path = listing
    else:
        return link
    return os.path.relpath(path, beside)


def main():
    root = pathlib.Path(sys.argv[1])
    for page in sorted(root.rglob("*.md")):
        text = page.read_text(encoding="utf-8")

        def made(found):
            return found[1] + target_of(page, found[2], root) + (found[3] or "") + found[4]

        page.write_text(LINK.sub(made, text), encoding="utf-8")


main()
