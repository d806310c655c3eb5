# SPDX-License-Identifier: BSD-3-Clause
"""A CT scan of a bonsai with soft shadows from an area light.

pvbatch shadows_of_a_bonsai.py PLUGIN Data/bonsai.vti IMAGE.png
"""

import sys

from paraview.simple import *

plugin, data, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[720, 720], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]
view.UseLight = 0  # only the area light

bonsai = OpenDataFile(data)
tree = ExtractSubset(Input=bonsai, VOI=[24, 210, 30, 255, 0, 255])  # without the supports
display = Show(tree, view)
display.SetRepresentationType("Shadowed Slices")
ColorBy(display, ("POINTS", "ImageFile"))
display.SetScalarBarVisibility(view, False)
colors = GetColorTransferFunction("ImageFile")
colors.RGBPoints = [  # leaves, wood and soil, stones
    40, 0.42, 0.62, 0.20, 70, 0.48, 0.60, 0.22, 95, 0.66, 0.50, 0.32, 150, 0.70, 0.54, 0.38,
    185, 0.62, 0.44, 0.32, 255, 0.85, 0.50, 0.36]
opacities = GetOpacityTransferFunction("ImageFile")
opacities.Points = [0, 0, 0.5, 0, 36, 0, 0.5, 0, 46, 0.5, 0.5, 0, 80, 0.7, 0.5, 0, 255, 0.9, 0.5, 0]

display.AreaLight = 1
display.AreaLightPosition, display.AreaLightFocalPoint = [-100, 420, -100], [122, 110, 128]
display.AreaLightWidth = display.AreaLightHeight = 120  # soft shadows
display.AreaLightIntensity = 1.4
display.Ambient = 0.35

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-0.1, 0.4, -1], [0, 0, 0], [0, 1, 0]
ResetCamera(view)
view.GetActiveCamera().Zoom(1.25)
SaveScreenshot(picture, view)
