#!/usr/bin/env python3
"""Every link, anchor and picture of the manual as HTML leads to something in its folder.

  check_html_manual.py FOLDER"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.targets, self.ids = [], set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src"):
                self.targets.append(value)
            elif name == "id":
                self.ids.add(value)


folder = pathlib.Path(sys.argv[1]).resolve()
pages = {file: Page(file) for file in folder.rglob("*.html")}
wrong = [] if pages else [f"{folder}: no pages"]
for file, page in pages.items():
    for target in page.targets:
        url = urllib.parse.urlparse(target)
        if url.scheme in ("http", "https"):
            continue
        path = (file.parent / urllib.parse.unquote(url.path)).resolve() if url.path else file
        found = path.is_file() and path.is_relative_to(folder) and not url.scheme
        if found and url.fragment:
            found = path in pages and urllib.parse.unquote(url.fragment) in pages[path].ids
        if not found:
            wrong.append(f"{file.name}: {target}")
print("\n".join(wrong))
sys.exit(bool(wrong))
