#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the built site: every link within it leads to a page and an anchor that exist, every picture,
script and style sheet is in it, and no page loads anything from the network.

    scripts/check_site.py FOLDER
"""
import html.parser
import pathlib
import sys
import urllib.parse

LOADED = {("img", "src"), ("script", "src"), ("video", "src"), ("source", "src"), ("video", "poster")}


class Page(html.parser.HTMLParser):
    """Collects the anchors of a page and (address, whether it is loaded) of its links."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors.update(values[name] for name in ("id", "name") if values.get(name))
        for name, value in attrs:
            if (tag, name) in LOADED:
                self.links.append((value, True))
            elif name == "href" and tag in ("a", "link"):
                self.links.append((value, tag == "link" and "stylesheet" in values.get("rel", "")))


def problem_of(site, page, address, is_loaded, pages):
    """Returns what is wrong with a link, or None."""
    parts = urllib.parse.urlsplit(address)
    if parts.scheme == "data":
        return None
    if parts.scheme or parts.netloc:
        return "is loaded from the network" if is_loaded else None
    target = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
    if not target.is_relative_to(site) or not target.is_file():
        return "does not exist"
    if parts.fragment and target in pages:
        anchor = urllib.parse.unquote(parts.fragment)
        return None if anchor in pages[target].anchors else "names an anchor that does not exist"
    return None


def problems_of(site):
    # Reports of runs are pages of their own, tested elsewhere.
    names = [name for name in site.rglob("*.html") if "_static" not in name.parts]
    pages = {name: Page(name.read_text()) for name in names}
    if not pages:
        yield f"{site}: no page"
    for name, page in sorted(pages.items()):
        for address, is_loaded in page.links:
            problem = problem_of(site, name, address, is_loaded, pages)
            if problem:
                yield f"{name.relative_to(site)}: {address} {problem}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    problems = list(problems_of(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(problems) or "no problem found")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
