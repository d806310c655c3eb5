# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the plugin contains a help page for each of its filters and sources, with a link to the guide.

Arguments: the compiled help (.qch), the plugin, and the server-manager XML files.
"""

import base64
import re
import sqlite3
import sys
import zlib
from xml.etree import ElementTree

from plugin_testing import Checks

PICTURED = ["IntervalVolume", "IsotableContour", "TimeVaryingIntervalVolume", "FlowVolume",
            "TetrahedralMesher"]


def read_pages(path):
    """Returns the files of a compiled help by name. It is a database of Qt-compressed data, each with a
    length prefix."""
    query = "SELECT Name, Data FROM FileNameTable, FileDataTable WHERE FileId = Id AND Data NOT NULL"
    return {name: zlib.decompress(data[4:]) for name, data in sqlite3.connect(path).execute(query)}


def shown_proxies(files):
    """Yields group and name of the proxies in menus."""
    for file in files:
        for group in ElementTree.parse(file).iter("ProxyGroup"):
            for proxy in group:
                if proxy.find("Hints/ShowInMenu") is not None:
                    yield group.get("name"), proxy.get("name")


def main():
    help_path, plugin_path, *files = sys.argv[1:]
    checks = Checks()
    pages = read_pages(help_path)
    proxies = list(shown_proxies(files))
    checks.that(len(proxies) > 15, f"the menus show {len(proxies)} proxies")
    for group, name in proxies:
        page = pages.get(f"{group}.{name}.html", b"").decode()
        checks.that('href="guide.html"' in page, f"the page of {name} links to the guide")
        if name in PICTURED:
            checks.that(f'src="{name}.png"' in page, f"the page of {name} has an image")
    for page in [text.decode() for name, text in pages.items() if name.endswith(".html")]:
        for picture in re.findall(r'<img [^>]*src="([^"]+)"', page):
            checks.that(pages.get(picture, b"").startswith(b"\x89PNG"), f"{picture} exists")
    checks.that(b"<h1>" in pages.get("guide.html", b""), "the guide exists")
    with open(help_path, "rb") as compiled, open(plugin_path, "rb") as plugin:
        checks.that(base64.b64encode(compiled.read(3000)) in plugin.read(), "the plugin contains the help")
    print(len(pages), "files,", len(proxies), "proxies", flush=True)
    checks.finish()


main()
