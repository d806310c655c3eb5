# SPDX-License-Identifier: BSD-3-Clause
"""A stream surface that parts at a sphere, with streamlines, and timelines that move with the flow.

pvbatch timelines_around_a_sphere.py PLUGIN FRAMES NUMBER

Writes FRAMES-000.png and so on. Only the offset of the timelines changes, so NUMBER frames are a loop.
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
mapping = InflowMapping(Input=field, Formula="v")
volume = FlowVolume(Input=mapping, Intervals=[], GenerateStreamSurfaces=1, StreamSurfaces=[0.47])
surfaces = StreamSurfaceParameters(Input=OutputPort(volume, 1))
display = Show(surfaces, view)
display.ColorArrayName = [None, ""]
display.AmbientColor = display.DiffuseColor = [0.55, 0.70, 0.90]
display.SetRepresentationType("Stream Surface")
display.StreamlineWidth = 0.12
display.StreamlineColor = [0.1, 0.2, 0.4]
display.Timelines = 1
display.NumberOfTimelines = 4
display.TimelineWidth = 0.15
display.TimelineColor = [0.8, 0.2, 0.1]
sphere = Show(Sphere(Radius=0.4, ThetaResolution=60, PhiResolution=60), view)
sphere.AmbientColor = sphere.DiffuseColor = [0.85, 0.80, 0.70]

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.6, -1, 1.1], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    display.TimelineOffset = frame / int(number) / 4
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
