# SPDX-License-Identifier: BSD-3-Clause
"""What a user of ParaView does first: an interval volume of a wavelet, by a plugin that nobody names here;
and a mesh of a sphere, by the program that runs TetGen."""

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
    # The client keeps what is printed for a window of its own.
    os.write(1, f"{numbers} tetrahedra in ParaView\n".encode())
    status = 0 if all(numbers) else 1
except Exception:
    os.write(2, traceback.format_exc().encode())
# The client would wait for its user.
os._exit(status)
