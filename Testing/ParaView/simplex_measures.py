# SPDX-License-Identifier: BSD-3-Clause
"""Simplices of a grid as NumPy arrays, and measures for comparing two builds of a filter."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy


def simplices(grid, chosen=slice(None)):
    """Returns the corner coordinates of all or the chosen cells, which must have equally many corners:
    (cells, corners, 3), or (cells, 5, 4) for 4-simplices with the point array Time."""
    if grid.GetNumberOfCells() == 0:
        return numpy.empty((0, 4, 3), numpy.float32)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    corners = numpy.unique(numpy.diff(offsets)[chosen])
    assert len(corners) == 1, "all cells must have the same number of corners"
    if corners == 5:
        points = numpy.column_stack([points, vtk_to_numpy(grid.GetPointData().GetArray("Time"))])
    ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return points[ids[offsets[:-1][chosen][:, None] + numpy.arange(corners[0])]]


def sizes(cells):
    """Returns areas of triangles, signed volumes of tetrahedra or hypervolumes of 4-simplices in double
    precision."""
    edges = cells[:, 1:].astype(float) - cells[:, :1]
    if cells.shape[1] == 5:
        return numpy.linalg.det(edges) / 24
    normals = numpy.cross(edges[:, 0], edges[:, 1])
    if cells.shape[1] == 3:
        return numpy.linalg.norm(normals, axis=1) / 2
    return numpy.einsum("ij,ij->i", normals, edges[:, 2]) / 6


def integrals(grid, array):
    """Returns the integral of a point array over each tetrahedron."""
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    values = vtk_to_numpy(grid.GetPointData().GetArray(array))
    return sizes(simplices(grid)) * values[corners].mean(axis=1)


def array_ranges(attributes):
    """Returns the range of the first component of each array, by name."""
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {array.GetName(): list(array.GetRange()) for array in arrays}


def counts(array):
    """Returns the number of occurrences of each value."""
    values, numbers = numpy.unique(vtk_to_numpy(array), return_counts=True)
    return {str(value): int(number) for value, number in zip(values, numbers)}


def measure(grid, id_array):
    """Returns the measures of an extraction, which must not be empty: `points`, `cells`, `bounds`, `size`
    (sum over the simplices), `hypervolume` (the integral of the point array DeltaT over tetrahedra, or 0
    without it), `ranges` (of each point and cell array, by name) and `by_id` (`id`, `cells` and `size` for
    each value of the cell array)."""
    ids = vtk_to_numpy(grid.GetCellData().GetArray(id_array))
    by_id = []
    for value in numpy.unique(ids).tolist():
        found = sizes(simplices(grid, ids == value))
        by_id.append({"id": value, "cells": len(found), "size": found.sum()})
    if not by_id:
        raise RuntimeError(f"There are no cells to measure by {id_array}.")
    ranges = {"point": array_ranges(grid.GetPointData()), "cell": array_ranges(grid.GetCellData())}
    return {
        "points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(), "bounds": list(grid.GetBounds()),
        "size": sum(part["size"] for part in by_id),
        "hypervolume": integrals(grid, "DeltaT").sum() if "DeltaT" in ranges["point"] else 0.0,
        "ranges": ranges, "by_id": by_id}
