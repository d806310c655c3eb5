# SPDX-License-Identifier: BSD-3-Clause
"""Tests the ParaView plugin: an interval volume of a wavelet, and a mesh of a sphere by the program that runs
TetGen. The plugin must be loaded without being named here."""

import os
import traceback

from paraview import simple

status = 1
try:
    volume = simple.IntervalVolume(Input=simple.Wavelet())
    volume.Scalars = ["POINTS", "RTData"]
    volume.Intervals = [140.0, 180.0]
    mesh = simple.TetrahedralMesher(Input=simple.Sphere())
    numbers = []
    for result in (volume, mesh):
        result.UpdatePipeline()
        numbers.append(result.GetDataInformation().GetNumberOfCells())
    # print() is not used, since the client shows printed text in a window.
    os.write(1, f"{numbers} tetrahedra in ParaView\n".encode())
    status = 0 if all(numbers) else 1
except Exception:
    os.write(2, traceback.format_exc().encode())
# Exit explicitly, since the client would otherwise wait for user input.
os._exit(status)
