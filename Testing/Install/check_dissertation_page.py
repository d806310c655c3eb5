#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_dissertation_page.py SOURCE: checks that the classes, tests, scenes, ParaView properties and figures in
Documentation/methods/dissertation.md exist.
"""
import re
import sys
from pathlib import Path

FIGURES = [f"{chapter}.{i}" for chapter, last in ((2, 55), (3, 30), (4, 18)) for i in range(1, last + 1)]
STATE = re.compile(r"whole(: .+)?|(better|partial|not done): .+")


def read_rows(text):
    """Returns the cells of the table rows that start with the number of a section or figure."""
    return [[cell.strip(" `") for cell in line.strip("|").split("|")] for line in re.findall(r"^\| \d\..*", text, re.M)]


def read_properties(text):
    """Returns the labels of the properties of each filter, source and representation."""
    properties = {}
    for section in text.split("\n### ")[1:]:
        name, _, rows = section.partition("\n")
        properties.setdefault(name, set()).update(re.findall(r"^\| ([^|]+?) \|", rows, re.M))
    return properties


def main(source):
    documents = source / "Documentation"
    rows = read_rows((documents / "methods/dissertation.md").read_text(encoding="utf-8"))
    properties = read_properties((documents / "guide/properties.md").read_text(encoding="utf-8"))
    modules, others = ({path.stem for folder in folders for path in (source / folder).rglob("*.h")}
                       for folders in (("Filters", "Rendering"), ("Utilities",)))
    scenes = {path.stem for path in (source / "Data/Baseline").glob("*.png")}
    tests = {f"TestGalleryScene-{scene}" for scene in scenes}
    for path in [*source.glob("Testing/**/CMakeLists.txt"), *source.glob("Testing/**/*.cmake")]:
        tests.update(re.findall(r"\bTest\w+", path.read_text(encoding="utf-8")))
    methods = [row for row in rows if len(row) == 8]
    figures = {row[0]: re.sub(r" \(.*", "", row[1]).split(", ") for row in rows if len(row) == 2}
    valid = {"complete rows": len(methods) + len(figures) == len(rows), "figures": list(figures) == FIGURES}
    for section, _, name, test, scene, paraview, python, state in methods:
        proxy, _, labels = paraview.partition(": ")
        valid[f"{section}: class {name}"] = name in {"-", *modules, *others}
        valid[f"{section}: test {test}"] = test in {"-", *tests}
        valid[f"{section}: scene {scene}"] = scene in {"-", *scenes}
        valid[f"{section}: {paraview}"] = paraview == "-" or set(labels.split(", ")) <= properties.get(proxy, set())
        valid[f"{section}: Python {python} for {name}"] = python == ("yes" if name in modules else "-")
        valid[f"{section}: state {state}"] = STATE.fullmatch(state) is not None
    for figure, names in figures.items():
        valid[f"figure {figure}: {names}"] = set(names) <= {"diagram", "chart", *scenes}
    for figure, scene, _ in read_rows((documents / "guide/README.md").read_text(encoding="utf-8")):
        valid[f"figure {figure}: {scene}, as in the guide"] = scene in figures.get(figure, [])
    errors = [f"missing or invalid: {what}" for what, is_valid in valid.items() if not is_valid]
    print(*errors, f"{len(methods)} methods, {len(figures)} figures, {len(errors)} errors", sep="\n")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
