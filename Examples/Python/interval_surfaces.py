# SPDX-License-Identifier: BSD-3-Clause
"""Adjacent intervals of functions on an image and on a sphere, as triangles with contour lines (figure 3.1).

python3 interval_surfaces.py IMAGE.png
"""

import numpy as np
from interlume import vtkIntervalVolume
from props import COLORS, make_actor, make_tubes, run, select_triangles
from stage import INK, Stage
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

image = vtkImageData()
image.SetDimensions(22, 17, 1)
image.SetSpacing(0.1, 0.1, 0.1)
sphere = vtkSphereSource()
sphere.SetThetaResolution(26)
sphere.SetPhiResolution(18)
stage = Stage()
for caption, data in (("an image", image), ("a sphere", run(sphere))):
    x, y, z = np.array([data.GetPoint(p) for p in range(data.GetNumberOfPoints())]).T
    data.GetPointData().SetScalars(
        numpy_to_vtk(0.5 + 0.25 * np.sin(4.0 * x + z) + 0.25 * np.cos(3.0 * y - 4.0 * x * y), deep=True))
    intervals = vtkIntervalVolume()
    intervals.GenerateBoundariesOn()
    for i in range(4):
        intervals.SetInterval(i, i / 4, (i + 1) / 4)
    bands = run(intervals, data)
    panel = stage.add_panel(caption)
    for i in range(4):
        actor = make_actor(run(vtkDataSetSurfaceFilter(), select_triangles(bands, "IntervalId", i)), COLORS[i])
        actor.GetProperty().EdgeVisibilityOn()
        panel.add(actor)
    panel.add(make_actor(make_tubes(intervals.GetOutputDataObject(1), 0.005 * data.GetLength()), INK))
stage.panels[0].look_from((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
stage.save()
