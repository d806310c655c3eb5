# SPDX-License-Identifier: BSD-3-Clause
"""A flow volume with one of its two boundary surfaces (figure 4.5).

python3 flow_volume_boundary.py IMAGE.png
"""

from interlume import vtkAnalyticFlowSource, vtkFlowVolume, vtkIntervalVolume
from props import (
    COLORS, add_gradient, make_actor, make_inflow, make_intervals, make_plane, run,
    select_triangles, set_boundary, set_gradient_normals)
from stage import Stage
from vtkmodules.vtkFiltersSources import vtkCubeSource

jet = vtkAnalyticFlowSource()
jet.SetField(jet.SADDLE)
jet.SetDimensions(17, 17, 17)
jet.SetBounds(-1.3, 1.3, -0.9, 0.9, 0.0, 1.0)
jet.SetSaddleRates(0.65, 0.35, -1.0)
nozzle = make_plane((0.0, 0.0, 1.0), (0.5, 0.0, 0.0), (0.0, 0.5, 0.0))
samples = ((81, 65, 41), (-1.3, 1.3, -0.9, 0.9, 0.02, 1.0))
inflow = make_inflow(jet, nozzle, samples, "sqrt((u - 0.5)^2 + (v - 0.5)^2)")
ring = vtkFlowVolume()
ring.SetInterval(0, 0.16, 0.42)
ring.GenerateStreamSurfacesOn()
volume = make_intervals(run(ring, add_gradient(inflow, "Inflow")), (COLORS[0], 0.8))
inner = select_triangles(ring.GetOutputDataObject(1), "StreamSurfaceId", 0)
set_gradient_normals(inner, vtkIntervalVolume.LOWER_SIDE)
set_boundary(volume, inner, COLORS[2], 1.0)
floor = vtkCubeSource()
floor.SetBounds(-1.3, 1.3, -0.9, 0.9, -0.06, 0.0)

stage = Stage()
stage.add_panel().add(volume, make_actor(run(floor), (0.76, 0.79, 0.82)))
stage.panels[0].ambient_occlusion = False
stage.panels[0].look_from((0.2, -1.0, 0.4))
stage.save()
