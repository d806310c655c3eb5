# SPDX-License-Identifier: BSD-3-Clause
"""An interval that moves through the densities of a tooth, from dentin to enamel.

pvbatch intervals_of_a_tooth.py PLUGIN Data/tooth.vti FRAMES NUMBER

Writes FRAMES-000.png and so on. NUMBER is the number of frames.
"""

import sys

from paraview.simple import *

plugin, data, frames, number = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[480, 480], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

tooth = OpenDataFile(data)
interval = IntervalVolume(Input=tooth, Scalars=["POINTS", "density"])
interval.Intervals = [110, 255]
display = Show(interval, view)
display.SetRepresentationType("Interval Volume")
ColorBy(display, ("POINTS", "density"))
display.SetScalarBarVisibility(view, False)
colors = GetColorTransferFunction("density")
colors.RGBPoints = [110, 0.75, 0.40, 0.30, 160, 0.84, 0.62, 0.42, 255, 0.42, 0.66, 0.86]
GetOpacityTransferFunction("density").Points = [110, 0.5, 0.5, 0, 255, 0.9, 0.5, 0]
display.IntervalOpacityUnitDistance = 6

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-1, -2, 0.6], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
for frame in range(int(number)):
    lower = 110 + 110 * frame / max(int(number) - 1, 1)
    interval.Intervals = [lower, lower + 35]
    SaveScreenshot(f"{frames}-{frame:03}.png", view)
