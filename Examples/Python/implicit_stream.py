# SPDX-License-Identifier: BSD-3-Clause
"""An implicit stream surface and a stream volume of a vortex (figure 4.3).

python3 implicit_stream.py IMAGE.png
"""

from interlume import vtkAnalyticFlowSource, vtkFlowVolume
from props import COLORS, make_actor, make_inflow, make_intervals, run, select_triangles
from stage import Stage
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

tornado = vtkAnalyticFlowSource()
tornado.SetField(tornado.TORNADO)
tornado.SetDimensions(49, 49, 33)
tornado.SetBounds(-1.5, 1.5, -1.5, 1.5, -1.0, 1.0)
tornado.SetCoreRadius(0.6)
tornado.SetCirculation(1.2)
ground = [(-1.5, -1.5, -0.8), (1.5, -1.5, -0.8), (-1.5, 1.5, -0.8)]
star = ("3 * sqrt((u - 0.5)^2 + (v - 0.5)^2)"
        " * (1 + 0.25 * cos(4 * atan2(v - 0.5, u - 0.5)))")
inflow = make_inflow(tornado, ground, (57, 57, 61), (-0.9, 0.9, -0.9, 0.9, -0.8, 1.0), star)
stream = vtkFlowVolume()
stream.SetInterval(0, 0.3, 0.6)
stream.GenerateStreamSurfacesOn()
stream.GenerateNormalsOn()
volume = make_intervals(run(stream, inflow), (COLORS[0], 3.0))
outer = select_triangles(stream.GetOutputDataObject(1), "StreamSurfaceId", 1)
surface = make_actor(run(vtkDataSetSurfaceFilter(), outer), COLORS[0])

stage = Stage()
stage.add_panel("the stream surface").add(surface)
stage.add_panel("the stream volume").add(volume)
stage.panels[0].look_from((0.25, -1.0, 0.5))
stage.panels[1].look_as(stage.panels[0])
stage.save()
