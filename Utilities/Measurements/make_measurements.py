#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_measurements.py [--check]: writes Documentation/measurements.md, the section "Measured" of README.md, and the
measured numbers in Documentation/guide.

The templates are Documentation/measurements/page.in.md and readme.in.md. The numbers are read from
Documentation/measurements/vtk-*/SUITE.json, which `interlume-bench SUITE --json FILE` writes.

Options: --check fails if a page is out of date. --take FILE splits rows.json of `interlume-bench report` into one file
per suite, in the directory of its VTK version. --folder FOLDER is the directory of README.md and Documentation/.
"""

import argparse
import sys
from pathlib import Path

from pages import Pages
from results import split_report


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help="fail if a page is out of date")
    parser.add_argument("--take", metavar="FILE", help="rows.json of a report, split into one file per suite first")
    parser.add_argument("--folder", type=Path, default=Path(__file__).resolve().parents[2],
                        help="directory of README.md and Documentation/")
    arguments = parser.parse_args()
    data = arguments.folder / "Documentation" / "measurements"
    if arguments.take:
        split_report(arguments.take, data)
    pages = Pages(data).written(arguments.folder)
    stale = [path for path, text in pages.items() if path.read_text(encoding="utf-8") != text]
    if arguments.check:
        for path in stale:
            print(f"{path} is not what its JSON says: run Utilities/Measurements/make_measurements.py",
                  file=sys.stderr)
        return 1 if stale else 0
    for path in stale:
        path.write_text(pages[path], encoding="utf-8")
        print(path)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except ValueError as error:
        sys.exit(f"make_measurements.py: {error}")
