# SPDX-License-Identifier: BSD-3-Clause
"""An implicit stream surface and a stream volume of a vortex (figure 4.3).

python3 implicit_stream.py IMAGE.png
"""

import numpy as np
from interlume import vtkAnalyticFlowSource, vtkFlowVolume
from props import (
    COLORS, add_gradient, get_axis, make_inflow, make_intervals, make_painted_actor, make_plane,
    make_rings, make_smooth_surface, run)
from stage import Stage

tornado = vtkAnalyticFlowSource()
tornado.SetField(tornado.TORNADO)
tornado.SetDimensions(49, 49, 33)
tornado.SetBounds(-1.5, 1.5, -1.5, 1.5, -1.0, 1.0)
tornado.SetCoreRadius(0.6)
tornado.SetCirculation(1.2)
ground = make_plane(get_axis(tornado, -0.8), (0.95, 0.0, 0.0), (0.0, 0.95, 0.0))
samples = make_rings(tornado, (25, 145, 49), (-0.8, 1.0), lambda outward, z: (
    (0.2 + 0.68 * outward) * np.sqrt((-0.8 + 1.0) / (z + 1.0))))
star = "1.9 * sqrt((u - 0.5)^2 + (v - 0.5)^2) * (1 + 0.25 * cos(4 * atan2(v - 0.5, u - 0.5)))"
stream = vtkFlowVolume()
stream.SetInterval(0, 0.3, 0.6)
stream.SetStreamSurface(0, 0.5)
stream.GenerateStreamSurfacesOn()
inflow = add_gradient(make_inflow(tornado, ground, samples, star), "Inflow")
volume = make_intervals(run(stream, inflow), (COLORS[0], 5.0))
surface = make_smooth_surface(stream, 1, COLORS[0])
paint = make_painted_actor(ground, lambda u, v: 1.9 * np.hypot(u - 0.5, v - 0.5) * (
    1.0 + 0.25 * np.cos(4.0 * np.arctan2(v - 0.5, u - 0.5))), 0.3, 0.6, COLORS[2], (0.76, 0.79, 0.82))

stage = Stage()
for panel in (stage.add_panel("the stream surface"), stage.add_panel("the stream volume")):
    panel.add(volume if panel.caption.endswith("volume") else surface, paint)
    panel.ambient_occlusion = False
    panel.look_from((0.25, -1.0, 0.35))
stage.panels[1].look_as(stage.panels[0])
stage.save()
