# SPDX-License-Identifier: BSD-3-Clause
"""What a user of ParaView does first: an interval volume of a wavelet, by a plugin that nobody names here."""

import os
import sys
import traceback

from paraview import simple

status = 1
try:
    volume = simple.IntervalVolume(Input=simple.Wavelet())
    volume.Scalars = ["POINTS", "RTData"]
    volume.Intervals = [140.0, 180.0]
    volume.UpdatePipeline()
    cells = volume.GetDataInformation().GetNumberOfCells()
    print(cells, "tetrahedra in ParaView", flush=True)
    status = 0 if cells > 0 else 1
except Exception:
    traceback.print_exc()
sys.stderr.flush()
# The client would wait for its user.
os._exit(status)
