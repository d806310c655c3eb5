# SPDX-License-Identifier: BSD-3-Clause
"""Drives the ParaView client as a new user would, and checks the images.

Arguments: a session of newcomer_uses.py and the output directory. After each use, something must cover at
least 5 % of the view, the image must equal its baseline, and the log must have no error or warning. With
INTERLUME_WRITE_BASELINES in the environment, the images become the baselines.
"""

import argparse
import json
import os
import re
import shutil

import numpy
from paraview import servermanager

from newcomer_client import play, python
from newcomer_uses import sessions
from plugin_images import pixels
from plugin_testing import Checks, data_path

SECONDS = 560  # Time limit of a session on a busy machine. An idle machine takes a tenth.
SMALLEST_FRACTION = 0.05  # Fraction of pixels that differ from the background.
SMALLEST_OUTLINE = 0.01  # Fraction for the outline of structured data that is only opened.
LARGEST_DIFFERENCE = 8  # Difference of a pixel from the baseline, in steps of 1/255.
LARGEST_FRACTION_OFF = 0.002  # Fraction of pixels that may differ more, such as edges.
LARGEST_MEAN = 0.25
# Expected representation by the first word of a use's name.
REPRESENTATIONS = {"intervals": "Interval Volume", "time": "Interval Volume", "slices": "Shadowed Slices"}
COLORED = ["intervals", "time", "slices", "contour", "flow"]
COMPLAINT = re.compile(r"ERR\||WARN\||ERROR:|Error:|Warning:|Traceback|Success = *false|critical:|FATAL", re.I)


def gestures(folder, uses):
    """Yields all gestures of a session, including the recording after each use."""
    yield python("import newcomer_record")
    for use, steps in uses.items():
        yield from steps
        yield python(f"newcomer_record.record({folder!r}, {use!r})")
        yield python("newcomer_record.reset()")


def compare(checks, use, drawn, baseline):
    expected = pixels(baseline)
    if drawn.shape != expected.shape:
        checks.that(False, f"{use} has the size of its baseline")
        return
    difference = numpy.abs(drawn - expected)
    off = numpy.mean((difference > LARGEST_DIFFERENCE).any(axis=1))
    print(f"  from the baseline: mean {difference.mean():.4f}, off {off:.5f}", flush=True)
    checks.that(off <= LARGEST_FRACTION_OFF, f"{use} equals its baseline: {off:.5f} of its pixels differ")
    checks.that(difference.mean() <= LARGEST_MEAN, f"{use} equals its baseline on average")


def check_use(checks, folder, use, baselines, write):
    path = os.path.join(folder, use + ".png")
    try:
        with open(os.path.join(folder, use + ".json"), encoding="utf-8") as file:
            facts = json.load(file)
        drawn = pixels(path)
    except FileNotFoundError:
        checks.that(False, f"{use} has an image")
        return
    background = numpy.round(255 * numpy.array(facts["background"]))
    fraction = numpy.mean((numpy.abs(drawn - background) > 2).any(axis=1))
    print(f"{use}: {fraction:.3f} of the view, {facts}", flush=True)
    outline = use.startswith("open-") and facts["representation"] == "Outline"
    smallest = SMALLEST_OUTLINE if outline else SMALLEST_FRACTION
    checks.that(fraction >= smallest, f"{use} is visible in {fraction:.4f} of the view")
    checks.that(facts["cells"] > 0, f"{use} has cells")
    family = use.split("-")[0]
    if family in REPRESENTATIONS:
        checks.equal(facts["representation"], REPRESENTATIONS[family], f"representation of {use}")
    if family in COLORED:
        checks.that(facts["colored by"], f"{use} is colored by an array")
    baseline = os.path.join(baselines, use + ".png")
    if write:
        shutil.copyfile(path, baseline)
    elif os.path.isdir(baselines):
        checks.that(os.path.exists(baseline), f"{use} has a baseline")
        if os.path.exists(baseline):
            compare(checks, use, drawn, baseline)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("session", choices=sessions())
    parser.add_argument("folder")
    arguments = parser.parse_args()
    folder = os.path.realpath(arguments.folder)
    os.makedirs(folder, exist_ok=True)
    # ParaView 6 has another default background and default colors.
    major = servermanager.vtkSMProxyManager.GetVersionMajor()
    baselines = data_path("Baseline/newcomer" if major < 6 else f"Baseline/newcomer-{major}")
    write = bool(os.environ.get("INTERLUME_WRITE_BASELINES"))
    if write:
        os.makedirs(baselines, exist_ok=True)
    uses = sessions()[arguments.session]
    for use in uses:
        for name in (use + ".png", use + ".json"):
            if os.path.exists(os.path.join(folder, name)):
                os.remove(os.path.join(folder, name))
    checks = Checks()
    status, log = play(gestures(folder, uses), folder, arguments.session, SECONDS)
    checks.equal(status, 0, "exit status of the client")
    for line in log:
        checks.that(not COMPLAINT.search(line), "no error or warning in the log: " + line)
    for use in uses:
        check_use(checks, folder, use, baselines, write)
    checks.finish()


main()
