# SPDX-License-Identifier: BSD-3-Clause
"""Tests the classes in ParaView's Python: a programmable filter must produce exactly the output of the plugin's
filter, and a report. Only the plugin configures where Python finds the classes.
"""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_testing import fetch, interval_volume, run

SCRIPT = """
from interlume import report, vtkIntervalVolume
intervals = vtkIntervalVolume()
intervals.SetInputData(self.GetInputDataObject(0, 0))
intervals.SetInterval(0, 130.0, 180.0)
intervals.Update()
self.GetOutputDataObject(0).ShallowCopy(intervals.GetOutput())
assert report(intervals)["CellsWithOutput"] > 0
"""


def arrays(grid):
    cells = grid.GetCells()
    parts = [grid.GetPoints().GetData(), cells.GetConnectivityArray(), cells.GetOffsetsArray()]
    for data in (grid.GetPointData(), grid.GetCellData()):
        parts.extend(data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return [vtk_to_numpy(part) for part in parts]


def main(checks):
    wavelet = simple.Wavelet()
    own = simple.ProgrammableFilter(Input=wavelet, OutputDataSetType="vtkUnstructuredGrid", Script=SCRIPT)
    found = arrays(fetch(own))
    expected = arrays(fetch(interval_volume(wavelet, "RTData", [[130.0, 180.0]])))
    checks.that(len(expected[1]) > 0, "the output has tetrahedra")
    checks.that(len(found) == len(expected), "both have the same number of arrays")
    for number, (one, other) in enumerate(zip(found, expected)):
        checks.that(np.array_equal(one, other), f"array {number} equals that of the plugin's filter")


run(main)
