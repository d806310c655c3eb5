# SPDX-License-Identifier: BSD-3-Clause
"""A hot region that spreads in a mug, sliced from 4-simplices at times between the time steps.

pvbatch mug_over_time.py PLUGIN Data/mug.ex2 FRAMES NUMBER

Writes FRAMES-000.png and so on. NUMBER is the number of frames.
"""

import sys

from paraview.simple import *

plugin, data, frames, number = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[480, 480], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

mug = OpenDataFile(data)
mug.UpdatePipeline()
over_time = TimeVaryingIntervalVolume(Input=mug, Scalars=["POINTS", "convected"])
over_time.Intervals = [0.5, 1.0]
over_time.GenerateSimplices = 1  # the slices are computed from these
start, end = mug.TimestepValues[0], mug.TimestepValues[-1]
at_time = SimplexTimeSlice(Input=OutputPort(over_time, 2), Time=0.5 * (start + end))
display = Show(at_time, view)
display.ColorArrayName = [None, ""]
display.AmbientColor = display.DiffuseColor = [0.80, 0.36, 0.25]
outline = Show(Outline(Input=mug), view)
outline.AmbientColor = outline.DiffuseColor = [0.5, 0.5, 0.5]

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.25, -1, 0.6], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    at_time.Time = start + (end - start) * (frame + 1) / int(number)
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
