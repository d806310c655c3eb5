# SPDX-License-Identifier: BSD-3-Clause
"""make_properties.py [--check] PAGE XML...: writes the guide's page of properties from the plugin's XML files.

The page lists the properties of filters, sources, termination surfaces, writers and representations.
With --check, the script writes nothing and fails if PAGE is out of date.
"""

import re
import sys
from pathlib import Path
from xml.etree import ElementTree

GROUPS = {"filters": "Filters", "sources": "Sources", "termination_surfaces": "Termination surfaces",
          "writers": "Writers", "representations": "Representations"}
HEAD = """# Properties in ParaView

This page lists the properties of the plugin's filters, sources and representations, with the text of their tooltips.
In Python, the name of a property is its label without spaces. `Plugin/Help/make_properties.py` generates the page from
the plugin's XML.
"""


def words(element):
    """Returns the text of an element on one line, escaped for a table cell."""
    return re.sub(r"\s+", " ", (element.text or "").strip()).replace("|", "\\|") if element is not None else ""


def label_of(element):
    return element.get("label") or re.sub(r"(?<=[a-z])(?=[A-Z])", " ", element.get("name"))


def default_of(element):
    """Returns the default value as shown in the panel, such as the text of an enumeration entry, on or off."""
    values = element.get("default_values") or ""
    for entry in element.iter("Entry"):
        if entry.get("value") == values:
            return entry.get("text")
    if element.find("BooleanDomain") is not None:
        return "on" if values == "1" else "off"
    return values if values != "none" else ""


def is_shown(element):
    return (element.tag.endswith("Property") and element.get("is_internal") != "1"
            and element.get("panel_visibility") != "never" and element.get("information_only") != "1"
            and element.find("Documentation") is not None)


def section(proxy, inherited, proxies):
    own = {item.get("name") for item in proxy if item.get("name")}
    items = [item for item in inherited if item.get("name") not in own] + list(proxy)
    for made in proxy.iterfind("SubProxy/Proxy"):
        items += proxies[made.get("proxygroup"), made.get("proxyname")]
    rows = [f"| {label_of(item)} | {default_of(item)} | {words(item.find('Documentation'))} |"
            for item in items if is_shown(item)]
    if not rows:
        return []
    return ["", f"### {label_of(proxy)}", "", words(proxy.find("Documentation")), "",
            "| property | default | description |", "| --- | --- | --- |", *rows]


def page(files):
    proxies = {}
    for file in sorted(files):
        root = ElementTree.parse(file).getroot()
        for group in root.iter("ProxyGroup"):
            for proxy in group:
                proxies[group.get("name"), proxy.get("name")] = proxy
                kind = root.find(f".//RepresentationType[@subproxy='{proxy.get('name')}']")
                if kind is not None:
                    proxy.set("label", kind.get("text"))
    lines = [HEAD.rstrip()]
    for group, title in GROUPS.items():
        lines += ["", f"## {title}"]
        for (owner, _), proxy in proxies.items():
            base = proxies.get((proxy.get("base_proxygroup"), proxy.get("base_proxyname")), ())
            if owner == group and proxy.tag != "Extension" and "Widget" not in proxy.get("name"):
                lines += section(proxy, base, proxies)
    return "\n".join(lines) + "\n"


def main():
    arguments = sys.argv[1:]
    check = arguments[0] == "--check"
    path, *files = map(Path, arguments[check:])
    text = page(files)
    if not check:
        path.write_text(text, encoding="utf-8")
    elif path.read_text(encoding="utf-8") != text:
        sys.exit(f"{path.name} is out of date. Run {Path(__file__).name} PAGE XML... to write it again.")


if __name__ == "__main__":
    main()
