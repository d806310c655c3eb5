# SPDX-License-Identifier: BSD-3-Clause
"""TestMeasurementsOfBench.py GENERATOR SOURCE ROWS [COSTS] [RANKS]: checks the tables that the templates of SOURCE
make from the output of interlume-bench (ROWS), interlume-bench-costs (COSTS) and interlume-bench-ranks (RANKS).

Every table must be on a page and have no empty lines.
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

# Tables whose rows need a full run: larger sizes, scenes of the gallery, or a VTK class that VTK 9.1 does not have.
NEED_FULL_RUN = {"tetrahedra", "flow.tubes", "shadows.equal-error", "mixed", "scattering", "scene-costs"}

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
    errors = []
    # The suites graphics-card and client do not exist here. The other suites belong to programs that are not always
    # built.
    optional = {"client", "graphics-card"} | {
        suite for suite, file in (("scene-costs", "costs.json"), ("ranks", "ranks.json"))
        if file not in {path.name for path in measured}}
    for name, table in TABLES.items():
        runs = results.of(table["suite"])
        if not runs and table["suite"] not in optional:
            errors.append(f"{name}: no suite {table['suite']} in {measured}")
        for run in runs:
            text = table_text(run, table)
            empty = [line for line in text.splitlines()[2:] if set(line.split("|")[2:-1]) == {" – "}]
            if (not text or empty) and name not in NEED_FULL_RUN:
                errors.append(f"{name}: {empty or 'no lines'}")
        if not any(f"{{{{table {name}}}}}" in words for words in templates_text):
            errors.append(f"{name} is on no page")
    Pages(data, explains=False).written(folder)
    if errors:
        sys.exit("ERROR: " + "\n".join(errors))
