# SPDX-License-Identifier: BSD-3-Clause
"""TestMeasurementsOfBench.py GENERATOR SOURCE ROWS [COSTS] [RANKS]: the templates of SOURCE with what interlume-bench
wrote to ROWS, and interlume-bench-costs and interlume-bench-ranks to COSTS and RANKS, where they were built.

Every table of a suite is made of it and is on a page, and none of them is empty.
"""

import shutil
import sys
import tempfile
from pathlib import Path

generator, source, *measured = map(Path, sys.argv[1:])
sys.path.insert(0, str(generator))

from pages import Pages, table_text  # noqa: E402
from results import Results, split_report  # noqa: E402
from tables import TABLES  # noqa: E402

# Their rows are of the full run alone: by sizes, by scenes of the gallery, or by a peer that VTK 9.1 lacks.
OF_FULL_RUNS = {"tetrahedra", "flow.tubes", "shadows.equal-error", "mixed", "scattering", "scene-costs"}

with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    data = folder / "Documentation" / "measurements"
    data.mkdir(parents=True)
    templates = source / "Documentation" / "measurements"
    templates_text = []
    for template in templates.glob("*.in.md"):
        shutil.copy(template, data)
        templates_text.append(template.read_text(encoding="utf-8"))
    shutil.copy(source / "README.md", folder)
    for path in measured:
        split_report(path, data)
    results = Results(data)
    wrong = []
    # The graphics card has no suite. The others are of programs that may not have been built.
    may_lack = {"graphics-card"} | {suite for suite, file in (("scene-costs", "costs.json"), ("ranks", "ranks.json"))
                               if file not in {path.name for path in measured}}
    for name, table in TABLES.items():
        runs = results.of(table["suite"])
        if not runs and table["suite"] not in may_lack:
            wrong.append(f"{name}: no suite {table['suite']} in {measured}")
        for run in runs:
            text = table_text(run, table)
            empty = [line for line in text.splitlines()[2:] if set(line.split("|")[2:-1]) == {" – "}]
            if (not text or empty) and name not in OF_FULL_RUNS:
                wrong.append(f"{name}: {empty or 'no lines'}")
        if not any(f"{{{{table {name}}}}}" in words for words in templates_text):
            wrong.append(f"{name} is on no page")
    Pages(data, explains=False).written(folder)
    if wrong:
        sys.exit("ERROR: " + "\n".join(wrong))
