# SPDX-License-Identifier: BSD-3-Clause
"""Pulses of dye that a flow carries around a sphere.

pvbatch dye_around_a_sphere.py PLUGIN FRAMES NUMBER

Writes FRAMES-000.png and so on. The NUMBER frames are a continuous loop: the field is traced once, and
only the phase of the pulses changes.
"""

import sys

from paraview.simple import *

plugin, frames, number = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[480, 480], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

flow = AnalyticFlow(Field="Sphere", Radius=0.4)
field = ImplicitFlowField(Input=flow, Vectors=["POINTS", "Velocity"])
field.SampleMode, field.SampleDimensions = "Image", [65, 33, 65]
field.SampleBounds = [-1, 1, 0, 1, -1, 1]  # the half behind the sphere's center
display = Show(field, view)
display.SetRepresentationType("Inflow Textures")
display.InflowTimePeriod, display.InflowPulseLength = 0.8, 0.4
sphere = Show(Sphere(Radius=0.4, ThetaResolution=60, PhiResolution=60), view)
sphere.AmbientColor = sphere.DiffuseColor = [0.85, 0.80, 0.70]

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.3, -1, 0.3], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    display.InflowTimePhase = frame / int(number)
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
