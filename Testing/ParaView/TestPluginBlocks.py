# SPDX-License-Identifier: BSD-3-Clause
"""Tests composite data: Interval Volume shows all blocks or the selected ones, and Shadowed Slices shows blocks
that fill a box together.
"""

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPartitionedDataSet

from plugin_images import (
    add_array, color_by, coordinates, fraction_shown, grid, image, look_at, plain_view, producer,
    snapshot)
from plugin_testing import open_file, run

SIDE = 5


def drawn(display):
    """Returns the input of the active representation's mapper."""
    active = display.GetClientSideObject().GetActiveRepresentation()
    return active.GetActor().GetMapper().GetInputDataObject(0, 0)


def blocks(make, kind=vtkMultiBlockDataSet, gap=0.0):
    """Returns two adjacent cubes, which form one regular grid if the gap is 0."""
    data = kind()
    for i in range(2):
        part = make(SIDE, (i * (SIDE - 1.0 + gap), 0.0, 0.0))
        points = coordinates(part)
        add_array(part, "value", points[:, 0] + 0.1 * points[:, 1])
        if kind is vtkMultiBlockDataSet:
            data.SetBlock(i, part)
        else:
            data.SetPartition(i, part)
    return data


def show(source, kind):
    view = plain_view()
    display = simple.Show(source, view)
    display.SetRepresentationType(kind)
    look_at(view)
    return view, display


def check_selection(checks):
    """Tests that all blocks are shown, or the selected ones as in ParaView's Volume."""
    cells = grid(SIDE).GetNumberOfCells()
    for kind in (vtkMultiBlockDataSet, vtkPartitionedDataSet):
        source = producer(blocks(grid, kind))
        view, display = show(source, "Interval Volume")
        shot = snapshot(view)
        checks.equal(drawn(display).GetNumberOfCells(), 2 * cells, f"{kind.__name__}, number of tetrahedra")
        checks.that(fraction_shown(shot) > 0.05, f"{kind.__name__} is visible")
        simple.Delete(view)
    view, display = show(producer(blocks(grid)), "Interval Volume")
    full = fraction_shown(snapshot(view))
    for selectors, number in ((["/Root/Block0"], 1), (["/Root/Block1"], 1), ([], 0), (["/"], 2)):
        display.BlockSelectors = selectors
        fraction = fraction_shown(snapshot(view))
        checks.equal(drawn(display).GetNumberOfCells() if number else 0, number * cells, f"{selectors}")
        display.SetRepresentationType("Volume")
        volume = fraction_shown(snapshot(view))
        display.SetRepresentationType("Interval Volume")
        checks.that(abs(fraction - volume) < 0.02, f"{selectors}: {fraction} of the image, {volume} as Volume")
        checks.that((fraction == 0.0, 0 < fraction < full, fraction == full)[number], f"{selectors}, {fraction}")
    simple.Delete(view)


def check_mug(checks):
    """Tests an Exodus file with default settings."""
    view, display = show(open_file("mug.ex2"), "Interval Volume")
    fraction = fraction_shown(snapshot(view))
    checks.that(fraction > 0.05, f"mug.ex2, {fraction} of the image")
    checks.that(drawn(display).GetNumberOfCells() > 0, "mug.ex2, tetrahedra")
    simple.Delete(view)


def check_images(checks):
    """Tests that images that fill a box are joined. Otherwise only the largest is shown, with a warning."""
    full = image(2 * SIDE - 1)
    full.SetDimensions(2 * SIDE - 1, SIDE, SIDE)
    points = coordinates(full)
    add_array(full, "value", points[:, 0] + 0.1 * points[:, 1])
    cells = numpy.arange(full.GetNumberOfCells(), dtype=float)
    view, display = show(producer(full), "Shadowed Slices")
    expected = snapshot(view)
    unit = display.ShadowedOpacityUnitDistance
    simple.Delete(view)
    for kind in (vtkMultiBlockDataSet, vtkPartitionedDataSet):
        view, display = show(producer(blocks(image, kind)), "Shadowed Slices")
        display.ShadowedOpacityUnitDistance = unit
        found = snapshot(view)
        checks.equal(int(numpy.abs(found - expected).max()), 0, f"{kind.__name__}, joined, pixel difference")
        checks.equal(drawn(display).GetNumberOfPoints(), len(points), f"{kind.__name__}, samples")
        simple.Delete(view)

    data = blocks(image)
    for i, part in enumerate(numpy.split(cells.reshape(SIDE - 1, SIDE - 1, -1), 2, axis=2)):
        add_array(data.GetBlock(i), "cell", part.ravel(), False)
    view, display = show(producer(data), "Shadowed Slices")
    color_by(display, ["CELLS", "cell"])
    snapshot(view)
    values = drawn(display).GetCellData().GetArray("cell")
    checks.that([values.GetValue(i) for i in range(len(cells))] == list(cells), "cells are in order")
    simple.Delete(view)

    one = vtkMultiBlockDataSet()
    one.SetBlock(0, full)
    for name, data, warnings in (("one", one, 0), ("with a gap", blocks(image, gap=0.5), 1)):
        view, display = show(producer(data), "Outline")
        display.SetRepresentationType("Shadowed Slices")
        active = display.GetClientSideObject().GetActiveRepresentation()
        messages = []
        active.AddObserver("WarningEvent", lambda _, event, to=messages: to.append(event))
        fraction = fraction_shown(snapshot(view))
        checks.that(fraction > 0.05, f"{name}, {fraction} of the image")
        checks.equal(len(messages), warnings, f"{name}, warnings")
        simple.Delete(view)


def main(checks):
    check_selection(checks)
    check_mug(checks)
    check_images(checks)


run(main)
