# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of composite data are drawn: by Interval Volume all, or those that are selected; by Shadowed
Slices those that fill a box together."""

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPartitionedDataSet

from plugin_pictures import (
    add_array, color_by, coordinates, grid, image, look_at, plain_view, producer, share_shown, snapshot)
from plugin_testing import open_file, run

SIDE = 5


def drawn(display):
    """What the mapper of the representation that is shown has as its input."""
    active = display.GetClientSideObject().GetActiveRepresentation()
    return active.GetActor().GetMapper().GetInputDataObject(0, 0)


def blocks(make, kind=vtkMultiBlockDataSet, gap=0.0):
    """Two cubes side by side, one lattice if the gap is 0."""
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
    """All blocks at first, then the one that is selected, as in ParaView's Volume."""
    cells = grid(SIDE).GetNumberOfCells()
    for kind in (vtkMultiBlockDataSet, vtkPartitionedDataSet):
        source = producer(blocks(grid, kind))
        view, display = show(source, "Interval Volume")
        shot = snapshot(view)
        checks.equal(drawn(display).GetNumberOfCells(), 2 * cells, f"{kind.__name__}, tetrahedra")
        checks.that(share_shown(shot) > 0.05, f"{kind.__name__} is shown")
        simple.Delete(view)
    view, display = show(producer(blocks(grid)), "Interval Volume")
    whole = share_shown(snapshot(view))
    for selectors, number in ((["/Root/Block0"], 1), (["/Root/Block1"], 1), ([], 0), (["/"], 2)):
        display.BlockSelectors = selectors
        share = share_shown(snapshot(view))
        checks.equal(drawn(display).GetNumberOfCells() if number else 0, number * cells, f"{selectors}")
        display.SetRepresentationType("Volume")
        volume = share_shown(snapshot(view))
        display.SetRepresentationType("Interval Volume")
        checks.that(abs(share - volume) < 0.02, f"{selectors}: {share} of the picture, Volume {volume}")
        checks.that((share == 0.0, 0 < share < whole, share == whole)[number], f"{selectors}, {share}")
    simple.Delete(view)


def check_mug(checks):
    """An Exodus file, as it opens."""
    view, display = show(open_file("mug.ex2"), "Interval Volume")
    share = share_shown(snapshot(view))
    checks.that(share > 0.05, f"mug.ex2, {share} of the picture")
    checks.that(drawn(display).GetNumberOfCells() > 0, "mug.ex2, tetrahedra")
    simple.Delete(view)


def check_images(checks):
    """Images that fill a box are drawn as the one image they are parts of; else the largest, with a
    warning."""
    whole = image(2 * SIDE - 1)
    whole.SetDimensions(2 * SIDE - 1, SIDE, SIDE)
    points = coordinates(whole)
    add_array(whole, "value", points[:, 0] + 0.1 * points[:, 1])
    cells = numpy.arange(whole.GetNumberOfCells(), dtype=float)
    view, display = show(producer(whole), "Shadowed Slices")
    expected = snapshot(view)
    unit = display.ShadowedOpacityUnitDistance
    simple.Delete(view)
    for kind in (vtkMultiBlockDataSet, vtkPartitionedDataSet):
        view, display = show(producer(blocks(image, kind)), "Shadowed Slices")
        display.ShadowedOpacityUnitDistance = unit
        found = snapshot(view)
        checks.equal(int(numpy.abs(found - expected).max()), 0, f"{kind.__name__}, joined, pixels")
        checks.equal(drawn(display).GetNumberOfPoints(), len(points), f"{kind.__name__}, samples")
        simple.Delete(view)

    data = blocks(image)
    for i, part in enumerate(numpy.split(cells.reshape(SIDE - 1, SIDE - 1, -1), 2, axis=2)):
        add_array(data.GetBlock(i), "cell", part.ravel(), False)
    view, display = show(producer(data), "Shadowed Slices")
    color_by(display, ["CELLS", "cell"])
    snapshot(view)
    values = drawn(display).GetCellData().GetArray("cell")
    checks.that([values.GetValue(i) for i in range(len(cells))] == list(cells), "cells in order")
    simple.Delete(view)

    one = vtkMultiBlockDataSet()
    one.SetBlock(0, whole)
    for name, data, warnings in (("one", one, 0), ("with a gap", blocks(image, gap=0.5), 1)):
        view, display = show(producer(data), "Outline")
        display.SetRepresentationType("Shadowed Slices")
        active = display.GetClientSideObject().GetActiveRepresentation()
        messages = []
        active.AddObserver("WarningEvent", lambda _, event, to=messages: to.append(event))
        share = share_shown(snapshot(view))
        checks.that(share > 0.05, f"{name}, {share} of the picture")
        checks.equal(len(messages), warnings, f"{name}, warnings")
        simple.Delete(view)


def main(checks):
    check_selection(checks)
    check_mug(checks)
    check_images(checks)


run(main)
