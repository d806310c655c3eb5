# SPDX-License-Identifier: BSD-3-Clause
"""Pulses of dye that the gas carries onto a hot spinning disk.

pvbatch dye_around_a_disk.py PLUGIN Data/disk_out_ref.vtu FRAMES NUMBER

Writes FRAMES-000.png and so on. The NUMBER frames are a continuous loop: the field is traced once, and
only the phase of the pulses changes.
"""

import sys

from paraview.simple import *

plugin, data, frames, number = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[480, 480], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

disk = OpenDataFile(data)
field = ImplicitFlowField(Input=disk, Vectors=["POINTS", "V"], TerminationSurface="Rectangle")
lid = field.TerminationSurface  # a square above the disk, through which gas enters
lid.Center, lid.Normal, lid.Lengths = [0, 0, 10.1], [0, 0, 1], [11.5, 11.5]
field.SampleMode = "Image"
field.SampleDimensions, field.SampleBounds = [49, 25, 57], [-5.7, 5.7, 0, 5.7, -3.5, 10.1]
field.MaximumTime = 8

display = Show(field, view)
display.SetRepresentationType("Inflow Textures")
display.InflowTimePeriod, display.InflowPulseLength = 1.2, 0.4
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.35, -1, 0.3], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    display.InflowTimePhase = frame / int(number)
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
