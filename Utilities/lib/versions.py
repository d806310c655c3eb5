# SPDX-License-Identifier: BSD-3-Clause
"""versions.py JSON PAGE [RESULTS...]: writes the table of versions into PAGE, between the lines <!-- versions -->
and <!-- end of versions -->, from the runs of Utilities/test that JSON keeps: the latest of each version.
RESULTS are files results.json of further runs, taken up first.

With --check before JSON: fails where the table is not what would be written.
"""

import json
import re
import sys
from pathlib import Path

HEAD = """| program | system | tests passed, failed, skipped | of these pictures passed | run on |
| --- | --- | --- | --- | --- |
"""


def take_up(runs, results):
    """Whole runs only: those of the modules are called vtk, those of the plugin paraview."""
    for run in results["runs"]:
        if run["name"] in ("vtk", "paraview"):
            runs[run["version"]] = {"date": results["date"], "system": results["system"],
                                    "compiler": results["compiler"], **run}


def order(version):
    program, number = version.split(",")[0].split()
    return (program == "ParaView", [int(part) for part in number.split(".")], version)


def row(run):
    return (f"| {run['version']} | {run['system']}, {run['compiler']} | {run['passed']}, {len(run['failed'])}, "
            f"{len(run['skipped'])} | {run['pictures passed']} of {run['pictures']} | {run['date']} |\n")


def footnotes(runs):
    """The names behind each number that is not of tests passed."""
    for version, run in runs.items():
        for result in ("failed", "skipped"):
            if run[result]:
                names = ", ".join(f"`{name}`" for name in run[result])
                yield f"{version}, {result}: {names}.\n"


def with_table(page, runs):
    notes = "\n".join(footnotes(runs))
    table = HEAD + "".join(map(row, runs.values())) + ("\n" + notes if notes else "")
    return re.sub(r"(<!-- versions -->\n).*?(<!-- end of versions -->)",
                  lambda found: found[1] + table + found[2], page, flags=re.DOTALL)


def main(arguments):
    check = arguments[0] == "--check"
    record, page, *results = map(Path, arguments[check:])
    runs = json.loads(record.read_text()) if record.exists() else {}
    for result in results:
        take_up(runs, json.loads(result.read_text()))
    runs = {version: runs[version] for version in sorted(runs, key=order)}
    text = page.read_text()
    table = with_table(text, runs)
    if check:
        sys.exit(0 if table == text else f"the table of versions in {page} is not that of {record}")
    record.write_text(json.dumps(runs, indent=1) + "\n")
    page.write_text(table)


main(sys.argv[1:])
