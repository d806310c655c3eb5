# SPDX-License-Identifier: BSD-3-Clause
"""Compares an extraction with the results from the build of the VTK modules."""

from vtkmodules.util.numpy_support import vtk_to_numpy
import numpy

from simplex_measures import array_ranges, integrals, simplices, sizes

TOLERANCE = 1e-12  # relative error of a sum, which depends on its order


def check_sum(checks, terms, expected, what):
    error, bound = abs(terms.sum() - expected), TOLERANCE * numpy.abs(terms).sum()
    checks.that(error <= bound, f"{what}: {terms.sum()!r}, expected {expected!r} within {bound!r}")


def compare(checks, name, grid, expected, id_array):
    """Compares a grid with expected measures, which are given per value of the cell array `id_array`."""
    checks.equal(grid.GetNumberOfCells(), expected["cells"], f"{name}, cells")
    checks.equal(grid.GetNumberOfPoints(), expected["points"], f"{name}, points")
    checks.equal(list(grid.GetBounds()), expected["bounds"], f"{name}, bounds")
    for kind, attributes in (("point", grid.GetPointData()), ("cell", grid.GetCellData())):
        checks.equal(array_ranges(attributes), expected["ranges"][kind], f"{name}, {kind} arrays")
    ids = vtk_to_numpy(grid.GetCellData().GetArray(id_array))
    checks.equal(
        numpy.unique(ids).tolist(), [part["id"] for part in expected["by_id"]], f"{name}, {id_array}")
    found = []
    for part in expected["by_id"]:
        what = f"{name}, {id_array} {part['id']}"
        chosen = ids == part["id"]
        checks.equal(chosen.sum(), part["cells"], f"{what}, cells")
        if chosen.any():
            found.append(sizes(simplices(grid, chosen)))
            check_sum(checks, found[-1], part["size"], f"{what}, size")
    check_sum(checks, numpy.concatenate(found or [numpy.zeros(0)]), expected["size"], f"{name}, size")
    if "DeltaT" in expected["ranges"]["point"]:
        check_sum(checks, integrals(grid, "DeltaT"), expected["hypervolume"], f"{name}, hypervolume")
