# SPDX-License-Identifier: BSD-3-Clause
"""Tests that a composite input produces a composite output of the same structure, with the same simplices per
leaf."""

import numpy
from paraview import simple

from plugin_testing import as_set, fetch, interval_volume, leaves, open_data, output_in_place, run
from simplex_measures import simplices

LEAVES = (("wavelet", "RTData", (140.0, 180.0)), ("disk_out_ref", "Temp", (400.0, 700.0)))


def renamed(name, array):
    """Returns the data with the scalars renamed to `value`, so that all leaves have the array."""
    calculator = simple.Calculator(Input=open_data(name))
    calculator.Function = array
    calculator.ResultArrayName = "value"
    calculator.UpdatePipeline()
    return calculator


def main(checks):
    sources = [renamed(name, array) for name, array, _ in LEAVES]
    intervals = [interval for _, _, interval in LEAVES]
    group = simple.GroupDatasets(Input=sources)

    contour = simple.IsotableContour(Input=group)
    contour.ContourBy = ["POINTS", "value"]
    contour.Isosurfaces = [value for pair in intervals for value in pair]
    tetrahedra = output_in_place(interval_volume(group, "value", intervals))
    triangles = output_in_place(contour)
    for name, output in (("interval volume", tetrahedra), ("contour", triangles)):
        checks.equal(output.GetClassName(), output_in_place(group).GetClassName(), f"{name}, class")
        checks.equal(len(list(leaves(output))), len(LEAVES), f"{name}, leaves")

    for (name, _, _), source, leaf in zip(LEAVES, sources, leaves(tetrahedra)):
        single = simplices(fetch(interval_volume(source, "value", intervals)))
        checks.that(len(single) > 0, f"{name} has tetrahedra")
        checks.that(numpy.array_equal(as_set(simplices(leaf)), as_set(single)), f"tetrahedra of {name}")
    for (name, _, _), leaf in zip(LEAVES, leaves(triangles)):
        checks.that(leaf.GetNumberOfCells() > 0, f"{name} has triangles")


run(main)
