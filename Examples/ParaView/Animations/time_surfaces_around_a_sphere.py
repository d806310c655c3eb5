# SPDX-License-Identifier: BSD-3-Clause
"""A time surface that a flow carries around a sphere.

pvbatch time_surfaces_around_a_sphere.py PLUGIN FRAMES NUMBER

Writes FRAMES-000.png and so on. The field is traced once; each of the NUMBER frames only extracts the
surface of another advection time.
"""

import sys

from paraview.simple import *

plugin, frames, number = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[480, 480], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

flow = AnalyticFlow(Field="Sphere", Radius=0.4)
field = ImplicitFlowField(Input=flow, Vectors=["POINTS", "Velocity"])  # from the plane through which the flow enters
volume = FlowVolume(Input=field, Intervals=[], GenerateTimeSurfaces=1, TimeSurfaces=[0.2])
display = Show(OutputPort(volume, 2), view)
display.ColorArrayName = [None, ""]
display.AmbientColor = display.DiffuseColor = [0.25, 0.45, 0.70]
sphere = Show(Sphere(Radius=0.4, ThetaResolution=60, PhiResolution=60), view)
sphere.AmbientColor = sphere.DiffuseColor = [0.85, 0.80, 0.70]
outline = Show(Outline(Input=flow), view)
outline.AmbientColor = outline.DiffuseColor = [0.5, 0.5, 0.5]

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.8, -1, 0.5], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    volume.TimeSurfaces = [0.2 + 1.8 * frame / max(int(number) - 1, 1)]
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
