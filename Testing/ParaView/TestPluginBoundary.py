# SPDX-License-Identifier: BSD-3-Clause
"""Tests boundary surfaces inside the representation Interval Volume: every triangle is drawn, each property changes
the image, images equal those of the C++ mapper, states restore them, and without a boundary nothing changes.

Argument: a directory for a state file.
"""

import os
import re
import sys

import numpy
from paraview import simple

from plugin_images import color_by, load_texture, look_at, plain_view, snapshot
from plugin_testing import data_path, interval_volume, open_data, output_in_place, run

RANGE = (140.0, 180.0)
LOWER, UPPER = 0, 1  # values of BoundarySide


def counts(display):
    """Returns the numbers of boundary triangles that were drawn, and that match no tetrahedron."""
    report = str(display.GetClientSideObject().GetActiveRepresentation()).split("Report:")[1]
    return [int(re.search(name + r": (\d+)", report).group(1)) for name in ("BoundaryTriangles", "UnmatchedTriangles")]


def show(data="wavelet", blocks=False):
    simple.ResetSession()
    source = open_data(data)
    if blocks:
        source = simple.GroupDatasets(Input=[source])
    volume = interval_volume(source, "RTData", [RANGE])
    volume.GenerateBoundaries = True
    view = plain_view()
    display = simple.Show(volume, view)
    display.SetRepresentationType("Interval Volume")
    color_by(display, None)
    display.IntervalOpacityUnitDistance = 5.0
    display.IntervalAutoAdjustLevelOfDetail = False
    look_at(view)
    return volume, view, display


def check_properties(checks):
    volume, view, display = show()
    without = snapshot(view)
    checks.equal(counts(display), [0, 0], "triangles without a boundary")
    boundary = simple.OutputPort(volume, 1)
    display.IntervalBoundary = boundary
    before = snapshot(view)
    triangles = output_in_place(volume, 1).GetNumberOfCells()
    checks.equal(counts(display), [triangles, 0], "triangles")
    checks.that((before != without).any(), "the boundary is visible")
    changes = (
        ("IntervalBoundaryColor", [1.0, 0.1, 0.1]), ("IntervalBoundaryOpacity", 0.9), ("IntervalBoundarySpecular", 0.8),
        ("IntervalBoundaryColors", [str(x) for x in (UPPER, 0.1, 0.1, 1.0, 0.8)]),
        ("IntervalBoundaryColors", [str(x) for x in (LOWER, 1.0, 0.1, 0.1, 0.8, UPPER, 0.1, 0.1, 1.0, 0.8)]),
        ("IntervalBoundaryIdArrayName", "IntervalId"), ("IntervalBoundaryColors", []),
        ("IntervalBoundaryIdArrayName", "BoundarySide"))
    for name, value in changes:
        setattr(display, name, value)
        after = snapshot(view)
        if name != "IntervalBoundaryIdArrayName" or value != "BoundarySide":
            checks.that((after != before).any(), f"{name} {value} changes the image")
        before = after
    volume.Intervals = [150.0, 200.0]
    checks.that((snapshot(view) != before).any(), "another interval")
    checks.equal(counts(display)[1], 0, "triangles of another interval")
    volume.Intervals = list(RANGE)
    display.IntervalBoundary = None
    checks.that(numpy.array_equal(snapshot(view), without), "without the boundary again")
    checks.equal(counts(display), [0, 0], "triangles without a boundary again")


def check_sides(checks):
    """Tests that a fully transparent side equals a boundary without this side."""
    volume, view, display = show()
    lower = simple.Threshold(Input=simple.OutputPort(volume, 1))
    lower.Scalars = ["CELLS", "BoundarySide"]
    lower.LowerThreshold = lower.UpperThreshold = LOWER
    display.IntervalBoundary = lower
    expected = snapshot(view)
    display.IntervalBoundary = simple.OutputPort(volume, 1)
    checks.that((snapshot(view) != expected).any(), "both sides")
    display.IntervalBoundaryColors = [str(x) for x in (UPPER, 1.0, 1.0, 1.0, 0.0)]
    checks.that(numpy.abs(snapshot(view) - expected).max() <= 1, "one transparent side")


def check_blocks(checks):
    volume, view, display = show(blocks=True)
    display.IntervalBoundary = simple.OutputPort(volume, 1)
    snapshot(view)
    found = counts(display)
    checks.that(found[0] > 1000 and found[1] == 0, f"triangles of blocks: {found}")


def check_texture(checks):
    volume, view, display = show()
    mapped = simple.TextureMaptoPlane(Input=simple.OutputPort(volume, 1))
    display.IntervalBoundary = mapped
    before = snapshot(view)
    display.IntervalBoundaryTexture = load_texture(data_path(os.path.join("Baseline", "flow-disk.png")))
    checks.that((snapshot(view) != before).any(), "the texture is visible")


def check_state(checks, folder):
    volume, view, display = show()
    display.IntervalBoundary = simple.OutputPort(volume, 1)
    display.IntervalBoundaryColors = [str(x) for x in (UPPER, 0.1, 0.1, 1.0, 0.8)]
    expected = snapshot(view)
    path = os.path.join(folder, "boundary.pvsm")
    simple.SaveState(path)
    simple.ResetSession()
    simple.LoadState(path)
    view = simple.GetActiveView()
    checks.that(numpy.array_equal(snapshot(view), expected), "the state restores the image")
    simple.Delete(view)  # before its window loses its display


def main(checks):
    check_properties(checks)
    check_sides(checks)
    check_blocks(checks)
    check_texture(checks)
    check_state(checks, sys.argv[1])


run(main)
