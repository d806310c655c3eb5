# SPDX-License-Identifier: BSD-3-Clause
"""Two intervals of a CT scan, dentin and enamel, rendered as volumes with different colors.

pvbatch intervals_of_a_tooth.py PLUGIN Data/tooth.vti IMAGE.png
"""

import sys

from paraview.simple import *

plugin, data, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[720, 720], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

tooth = OpenDataFile(data)
intervals = IntervalVolume(Input=tooth, Scalars=["POINTS", "density"])
intervals.Intervals = [110, 150, 190, 255]  # lower and upper bounds: dentin, enamel

display = Show(intervals, view)
display.SetRepresentationType("Interval Volume")
ColorBy(display, ("CELLS", "IntervalId"))
display.SetScalarBarVisibility(view, False)
colors = GetColorTransferFunction("IntervalId")
colors.RGBPoints = [0, 0.84, 0.62, 0.42, 1, 0.42, 0.66, 0.86]
opacities = GetOpacityTransferFunction("IntervalId")
opacities.Points = [0, 0.25, 0.5, 0, 1, 0.9, 0.5, 0]
display.IntervalOpacityUnitDistance = 6

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-1, -2, 0.6], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
view.GetActiveCamera().Zoom(1.1)
SaveScreenshot(picture, view)
