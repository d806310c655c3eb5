# SPDX-License-Identifier: BSD-3-Clause
"""Tests that every file in Data/ opens in ParaView, has cells, and has the point arrays listed in the
manifest."""

import os

from paraview import simple
from plugin_testing import Checks, data_path, manifest_arrays

checks = Checks()
arrays = manifest_arrays()
files = sorted(name for name in os.listdir(data_path("")) if os.path.isfile(data_path(name)))
checks.equal(sorted(arrays), [name for name in files if name != "MANIFEST.md"], "files")
for name, expected in arrays.items():
    reader = simple.OpenDataFile(data_path(name))
    reader.UpdatePipelineInformation()
    # Use the last time step: the first is constant.
    reader.UpdatePipeline(*list(getattr(reader, "TimestepValues", None) or [])[-1:])
    found = {array.Name for array in reader.PointData}
    print(name, reader.GetDataInformation().GetNumberOfCells(), "cells", sorted(found), flush=True)
    checks.that(reader.GetDataInformation().GetNumberOfCells() > 0, f"{name} has cells")
    # The Exodus reader adds point ids.
    checks.equal(found - {"ids"}, set(expected), f"arrays of {name}")
    for array in reader.PointData:
        checks.that(array.GetRange(0)[0] < array.GetRange(0)[1], f"{array.Name} of {name} varies")
    simple.Delete(reader)
checks.finish()
