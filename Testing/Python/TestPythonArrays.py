# SPDX-License-Identifier: BSD-3-Clause
"""Tests NumPy arrays as input and output of a filter: volumes of intervals of a linear field against a
formula, shared memory with NumPy, and the values of the report.
"""

import numpy as np
from interlume import report, vtkInterlumeReport, vtkIntervalVolume
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData

size = 9
z, y, x = np.mgrid[0:size, 0:size, 0:size].astype(float)
values = np.ascontiguousarray(x + 2.0 * y + 4.0 * z).ravel()
image = vtkImageData()
image.SetDimensions(size, size, size)
scalars = numpy_to_vtk(values)
scalars.SetName("height")
image.GetPointData().SetScalars(scalars)

intervals = vtkIntervalVolume()
intervals.SetInputData(image)
intervals.SetInterval(0, 15.0, 25.0)
intervals.SetInterval(1, 25.0, 41.0)
intervals.SetOutputPointsPrecision(intervals.DOUBLE_PRECISION)
intervals.Update()
grid = intervals.GetOutput()

points = vtk_to_numpy(grid.GetPoints().GetData())
corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
ids = vtk_to_numpy(grid.GetCellData().GetArray("IntervalId"))
a, b, c, d = (points[corners[:, i]] for i in range(4))
volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6.0


def volume_below(height):
    """Returns the volume of the part of [0, 8]^3 with x + 2 y + 4 z <= height, by inclusion and exclusion."""
    cubes = 0.0
    for corner in range(8):
        sides = [corner >> axis & 1 for axis in range(3)]
        rest = height - sum(8.0 * s * w for s, w in zip(sides, (1.0, 2.0, 4.0)))
        cubes += (-1.0) ** sum(sides) * max(rest, 0.0) ** 3 / (6.0 * 8.0)
    return cubes


for number, (lower, upper) in enumerate([(15.0, 25.0), (25.0, 41.0)]):
    expected = volume_below(upper) - volume_below(lower)
    found = np.abs(volumes[ids == number]).sum()
    assert abs(found - expected) < 1e-9 * expected, (number, found, expected)
field = vtk_to_numpy(grid.GetPointData().GetArray("height"))
assert np.abs(field - points @ [1.0, 2.0, 4.0]).max() < 1e-12 * values.max()

values[:] = 0.0
scalars.Modified()
intervals.WarnOnEmptyOutputOff()
intervals.Update()
assert intervals.GetOutput().GetNumberOfCells() == 0, "the filter must use the memory of the array"
counts = report(intervals)
assert counts["Cells"] == (size - 1) ** 3 and counts["CellsWithOutput"] == 0, counts


values = vtkInterlumeReport()
numbers = vtkDoubleArray()
numbers.SetName("Range")
numbers.InsertNextValue(0.5)
numbers.InsertNextValue(1e3)
texts = vtkStringArray()
texts.SetName("Reason")
texts.InsertNextValue("none given")
empty = vtkDoubleArray()
empty.SetName("Empty")
for array in (numbers, texts, empty):
    values.AddArray(array)


class Reported:
    def GetReport(self):
        return values


assert report(Reported()) == {"Range": (0.5, 1e3), "Reason": "none given", "Empty": ()}
same = vtkInterlumeReport()
same.DeepCopy(values)
assert same.IsEqual(values)
lines = [line.strip() for line in str(same).splitlines()]
assert lines[1:4] == ["Range: 0.5 1000", "Reason: none given", "Empty:"], str(same)
same.GetAbstractArray("Range").SetValue(1, 2.0)
assert not same.IsEqual(values)
try:
    report(vtkInterlumeReport())
    raise AssertionError("an unconnected report raises no TypeError")
except TypeError:
    pass
