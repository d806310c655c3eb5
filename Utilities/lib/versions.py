# SPDX-License-Identifier: BSD-3-Clause
"""versions.py [--check] JSON PAGE [RESULTS...]: writes the table of versions into PAGE, between the lines
<!-- versions --> and <!-- end of versions -->. JSON stores the latest run of Utilities/test for each version.
RESULTS are files results.json of further runs, which are added to JSON first.

With --check: fails if the table in PAGE is not up to date.
"""

import json
import re
import sys
from pathlib import Path

HEAD = """| program | system | tests passed, failed, skipped | of these, images passed | run on |
| --- | --- | --- | --- | --- |
"""


def add_results(runs, results):
    """Adds complete runs: vtk for the modules and paraview for the plugin."""
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
    """Yields the names of failed and skipped tests."""
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
        add_results(runs, json.loads(result.read_text()))
    runs = {version: runs[version] for version in sorted(runs, key=order)}
    text = page.read_text()
    table = with_table(text, runs)
    if check:
        sys.exit(0 if table == text else f"The table of versions in {page} does not match {record}. Run Utilities/versions.")
    record.write_text(json.dumps(runs, indent=1) + "\n")
    page.write_text(table)


main(sys.argv[1:])
