#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_pages.py SITE   Links and anchors of the pages of SITE (but of the API reference) lead somewhere, and
the search knows every page. Prints those that do not, and then fails."""
import html.parser
import json
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], {""}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        names = dict(attributes)
        self.anchors.update(names[k] for k in ("id", "name") if names.get(k))
        for key in ("href", "src"):
            if tag in ("a", "img", "script", "link") and names.get(key):
                self.links.append(names[key])


def main():
    site = pathlib.Path(sys.argv[1])
    pages = {p: Page(p) for p in site.rglob("*.html") if not p.is_relative_to(site / "api")}
    broken = 0
    for path, page in sorted(pages.items()):
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or link.startswith("//"):
                continue
            file = urllib.parse.unquote(parts.path)
            target = (path.parent / file).resolve() if file else path
            if target.is_dir():
                target = target / "index.html"
            anchors = pages[target].anchors if target in pages else None
            if not target.exists() or (anchors is not None and parts.fragment not in anchors):
                print(f"{path.relative_to(site)}: leads nowhere: {link}")
                broken += 1

    index = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))
    found = {urllib.parse.urlsplit(entry["location"]).path for entry in index["docs"]}
    for path in pages:
        name = str(path.relative_to(site))
        if name not in found and name not in ("index.html", "search.html"):
            print(f"the search does not know {name}")
            broken += 1
    print(f"{len(pages)} pages, {broken} faults")
    sys.exit(broken > 0)


main()
