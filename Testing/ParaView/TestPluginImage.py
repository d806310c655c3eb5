# SPDX-License-Identifier: BSD-3-Clause
"""Renders two interval volumes of a real dataset in ParaView, as a user would.

Argument: the PNG file to write. The image must show the colors of both intervals.
"""

import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from plugin_testing import interval_volume, open_data, run

SIZE = [1000, 750]
BACKGROUND = [0.93, 0.93, 0.94]
COOL = [0.36, 0.58, 0.90]
WARM = [0.95, 0.48, 0.30]
SMALLEST_FRACTION = 0.05  # fraction of the image, for each interval
LARGEST_FRACTION = 0.80


def draw(path):
    source = open_data("disk_out_ref")
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = False
    view.Background = BACKGROUND
    view.OrientationAxesVisibility = False
    for interval, color in (([340.0, 420.0], COOL), ([600.0, 900.0], WARM)):
        volume = interval_volume(source, "Temp", [interval])
        half = simple.Clip(Input=volume, ClipType="Plane")
        half.ClipType.Normal = [0.0, 1.0, 0.0]
        half.ClipType.Origin = [0.0, 0.0, 0.0]
        display = simple.Show(half, view)
        display.ColorArrayName = [None, ""]
        display.DiffuseColor = color
        display.AmbientColor = color
        display.Ambient = 0.15
        display.Specular = 0.2
    view.CameraPosition = [9.0, 28.0, 13.0]
    view.CameraFocalPoint = [0.0, 0.0, -0.4]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    view.GetActiveCamera().Zoom(1.12)
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)
    simple.Delete(view)  # before its window loses its display


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return values[:, :3].astype(float) / 255


def main(checks):
    draw(sys.argv[1])
    red, _, blue = pixels(sys.argv[1]).T
    for name, shown in (("cool", blue - red > 0.1), ("warm", red - blue > 0.1)):
        fraction = numpy.mean(shown)
        print(f"{name} fraction of the image: {fraction:.3f}")
        checks.that(SMALLEST_FRACTION < fraction < LARGEST_FRACTION, f"the {name} interval is visible")


run(main)
