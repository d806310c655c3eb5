#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""draw_plots.py PROGRAM: redraws the plots of Documentation/measurements.md, pictures/measured-*.svg.

PROGRAM is interlume-bench. It draws from the rows in Documentation/measurements/vtk-*/SUITE.json of the newest VTK that
has results of the suite.
"""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from results import Results

PICTURE = re.compile(r"\(pictures/measured-([\w-]+)\.svg\)")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", type=Path, help="interlume-bench")
    program = parser.parse_args().program.resolve()
    documentation = Path(__file__).resolve().parents[2] / "Documentation"
    measurements = documentation / "measurements"
    wanted = set(PICTURE.findall((measurements / "page.in.md").read_text(encoding="utf-8")))
    results = Results(measurements)
    for suite in results.suites():
        run = results.of(suite)[-1]
        # These rows were written by a program that draws no plots.
        if "command" in run.conditions:
            continue
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([program, suite, "--from", run.path, "--plots", folder], check=True)
            for plot in Path(folder).glob("*.svg"):
                if plot.stem in wanted:
                    shutil.copyfile(plot, documentation / "pictures" / f"measured-{plot.name}")
                    wanted.remove(plot.stem)
    if wanted:
        raise ValueError(f"no plot: {', '.join(sorted(wanted))}")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, subprocess.CalledProcessError) as error:
        sys.exit(f"draw_plots.py: {error}")
