# SPDX-License-Identifier: BSD-3-Clause
"""A hot region in a mug at four times, sliced from 4-simplices over all time steps.

pvbatch mug_over_time.py PLUGIN Data/mug.ex2 IMAGE.png
"""

import sys

from paraview.simple import *

plugin, data, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[960, 480], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

mug = OpenDataFile(data)
mug.UpdatePipeline()
over_time = TimeVaryingIntervalVolume(Input=mug, Scalars=["POINTS", "convected"])
over_time.Intervals = [0.5, 1.0]
over_time.GenerateSimplices = 1  # the time slices are computed from these

start, end = mug.TimestepValues[0], mug.TimestepValues[-1]
for index, fraction in enumerate((0.2, 0.4, 0.7, 1.0)):
    at_time = SimplexTimeSlice(Input=OutputPort(over_time, 2), Time=start + fraction * (end - start))
    moved = Transform(Input=at_time)
    moved.Transform.Translate = [5 * index, 0, 0]
    display = Show(moved, view)
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = [0.86 - 0.12 * index, 0.36, 0.22 + 0.12 * index]
    display.Ambient = 0.3

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.25, -1, 0.6], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
view.GetActiveCamera().Zoom(1.5)
SaveScreenshot(picture, view)
