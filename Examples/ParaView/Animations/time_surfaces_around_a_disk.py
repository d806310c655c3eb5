# SPDX-License-Identifier: BSD-3-Clause
"""A time surface that starts above a hot spinning disk and is carried by the gas.

pvbatch time_surfaces_around_a_disk.py PLUGIN Data/disk_out_ref.vtu FRAMES NUMBER

Writes FRAMES-000.png and so on. The field is traced once; each of the NUMBER frames only extracts the
surface of another advection time.
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
field.SampleDimensions, field.SampleBounds = [49, 49, 57], [-5.7, 5.7, -5.7, 5.7, -3.5, 10.1]
field.MaximumTime = 8
volume = FlowVolume(Input=field, Intervals=[], GenerateTimeSurfaces=1, TimeSurfaces=[0.5])
display = Show(OutputPort(volume, 2), view)
display.ColorArrayName = [None, ""]
display.AmbientColor = display.DiffuseColor = [0.25, 0.45, 0.70]
outline = Show(Outline(Input=disk), view)
outline.AmbientColor = outline.DiffuseColor = [0.5, 0.5, 0.5]

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.35, -1, 0.5], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    volume.TimeSurfaces = [0.5 + 5 * frame / max(int(number) - 1, 1)]
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
