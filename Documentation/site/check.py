# SPDX-License-Identifier: BSD-3-Clause
"""Checks the website in a folder.

    check.py SITE [PICTURES]

Checks that links, anchors and images exist. With PICTURES, opens each page in Chromium at two widths, checks the
layout, the images, the formulas and the search, and writes screenshots of the main pages to that directory.
"""

import json
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

WIDTHS = (400, 1400)
PICTURED = ["index", "README", "gallery/index", "gallery/clouds-full", "api/cpp/index", "api/cpp/vtkIntervalVolume",
            "api/python/Intervals", "Documentation/guide/README", "Documentation/guide/intervals",
            "Documentation/guide/properties", "Documentation/methods/scattering", "Documentation/methods/implicit-flow",
            "Documentation/measurements", "Documentation/architecture", "CHANGELOG", "search"]


class Links(HTMLParser):
    """Collects the anchors of a page, and the addresses to which it refers."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.addresses = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        self.addresses |= {attributes[key] for key in ("href", "src", "data") if attributes.get(key)}


def check_links(site, pages):
    """Returns messages about addresses within the site that do not exist."""
    links = {page: Links(page.read_text()) for page in pages}
    errors = []
    for page, found in links.items():
        for address in found.addresses:
            parts = urlsplit(address)
            if parts.scheme or parts.netloc:
                continue
            target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
            if not target.is_file() or site not in target.parents:
                errors.append(f"{page.relative_to(site)}: {address} does not exist")
            elif parts.fragment and target in links and unquote(parts.fragment) not in links[target].anchors:
                errors.append(f"{page.relative_to(site)}: {address} has no such anchor")
    return errors


def open_browser():
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"):
        options.add_argument(argument)
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def set_width(browser, width, height=1000):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})


# Reports the width of the layout, broken images, and invalid formulas, after formulas are laid out.
LAYOUT = """
const done = arguments[0];
const report = () => done([
  document.documentElement.scrollWidth,
  [...document.images].filter(i => i.complete && !i.naturalWidth && i.loading != "lazy").map(i => i.src),
  [...document.querySelectorAll(".merror, .MathJax_Error")].map(e => e.textContent)]);
window.MathJax ? MathJax.Hub.Queue(report) : report();
"""


def check_layout(browser, site, pages, pictures):
    """Returns messages about pages that are wider than the window, and about missing images and formulas."""
    errors = []
    for width in WIDTHS:
        set_width(browser, width)
        for page in pages:
            browser.get(page.as_uri())
            layout, images, formulas = browser.execute_async_script(LAYOUT)
            name = page.relative_to(site).with_suffix("").as_posix()
            if layout > width:
                errors.append(f"{name}: {layout} pixels wide in a window of {width}")
            errors += [f"{name}: the browser cannot show {image}" for image in images]
            errors += [f"{name}: the formula {formula} is invalid" for formula in formulas]
            if name in PICTURED:
                browser.save_screenshot(str(pictures / f"{name.replace('/', '-')}-{width}.png"))
    return errors


# Reports the first results, after the search has ended.
RESULTS = """
const done = arguments[0];
const report = () => /Search finished|did not match/.test(document.querySelector("#search-results").textContent)
  ? done([...document.querySelectorAll("#search-results li > a")].slice(0, 5).map(link => new URL(link.href).pathname))
  : setTimeout(report, 20);
report();
"""


def find_first(browser, site, term):
    """Returns the first pages that the search finds."""
    browser.get((site / "search.html").as_uri() + "?q=" + quote(term))
    addresses = browser.execute_async_script(RESULTS)
    return [Path(unquote(address)).relative_to(site).with_suffix("").as_posix() for address in addresses]


def check_search(browser, site, terms):
    errors = []
    for term, expected in terms.items():
        found = find_first(browser, site, term)
        if found[:1] not in [[page] for page in expected]:
            errors.append(f"search for {term}: {', '.join(found) or 'nothing'} instead of {' or '.join(expected)}")
    return errors


def check_in_browser(site, pages, pictures):
    pictures.mkdir(parents=True, exist_ok=True)
    terms = json.loads((Path(__file__).parent / "search-terms.json").read_text())
    with open_browser() as browser:
        browser.set_script_timeout(60)
        errors = check_layout(browser, site, pages, pictures) + check_search(browser, site, terms)
    print(f"{len(pages)} pages at {len(WIDTHS)} widths, {len(terms)} searches")
    return errors


def main():
    site, *pictures = (Path(argument).resolve() for argument in sys.argv[1:])
    pages = sorted(page for page in site.rglob("*.html") if "_static" not in page.parts)
    errors = check_links(site, pages)
    if pictures:
        errors += check_in_browser(site, pages, pictures[0])
    print("\n".join(errors + [f"{len(pages)} pages, {len(errors)} errors"]))
    return 1 if errors or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
