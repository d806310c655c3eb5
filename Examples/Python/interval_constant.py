# SPDX-License-Identifier: BSD-3-Clause
"""Four intervals of a scanned tooth (figure 3.4). NumPy hides cells and counts tetrahedra.

python3 interval_constant.py IMAGE.png
"""

import numpy as np
from interlume import vtkIntervalVolume, vtkTimeWeightedTetrahedraMapper
from props import (
    COLORS, add_gradient, make_boundary, make_intervals, read, reduce, run, set_boundary)
from stage import Stage
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes as attributes

bounds, extinctions = [115.0, 150.0, 172.0, 205.0, 255.0], [0.035, 0.035, 0.12, 0.2]
intervals = vtkIntervalVolume()
intervals.GenerateBoundariesOn()
for i in range(4):
    intervals.SetInterval(i, bounds[i], bounds[i + 1])
stage = Stage()
for caption in ("the whole mesh", "a quarter of the cells hidden"):
    tooth = reduce(read("tooth.vti"), 2)
    if stage.panels:
        x, y, _ = (s * np.arange(1, n) + o for n, s, o in zip(
            tooth.GetDimensions(), tooth.GetSpacing(), tooth.GetOrigin()))
        hidden = np.where((y[:, None] <= 46.0) & (x <= 52.0), attributes.HIDDENCELL, 0)
        ghosts = np.tile(hidden.ravel(), tooth.GetDimensions()[2] - 1).astype(np.uint8)
        tooth.GetCellData().AddArray(numpy_to_vtk(ghosts, deep=True))
        tooth.GetCellData().GetArray(0).SetName(attributes.GhostArrayName())
    mesh = run(intervals, add_gradient(tooth, "density"))
    print(np.bincount(vtk_to_numpy(mesh.GetCellData().GetArray("IntervalId"))), "tetrahedra")
    volume = make_intervals(mesh, *zip(COLORS, extinctions))
    volume.GetMapper().SetBlendModeToComposite()
    volume.GetMapper().SetSortMode(vtkTimeWeightedTetrahedraMapper.MPVONC_SORT)
    set_boundary(volume, make_boundary(intervals, intervals.LOWER_SIDE), (1.0, 1.0, 1.0), 0.06)
    stage.add_panel(caption).add(volume)
stage.panels[0].look_from((-0.8, -1.0, 0.35))
stage.panels[1].look_as(stage.panels[0])
stage.set_color_key(COLORS, bounds)
stage.save()
