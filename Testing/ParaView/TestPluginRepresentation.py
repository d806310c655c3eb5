"""The representation Interval Volume draws what the mapper draws in C++, pixel by pixel.

Argument: the folder for the pictures.
"""

import json
import os
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from plugin_testing import Checks, extractions_path, interval_volume, load_plugin, open_data

REPRESENTATION = "Interval Volume"
# Steps of 1/255. Both round the same numbers, in other versions of VTK.
LARGEST_DIFFERENCE = 1
LARGEST_MEAN = 0.2
SMALLEST_CHANGE = 0.5  # mean difference of pictures drawn in other ways
SMALLEST_SHARE = 0.25  # of the picture that shows something


def draw(picture, path):
    volume = interval_volume(open_data(picture["data"]), picture["array"], picture["intervals"])
    view = simple.CreateView("RenderView")
    view.ViewSize = picture["size"]
    view.UseColorPaletteForBackground = False
    view.Background = picture["background"]
    view.OrientationAxesVisibility = False
    view.CameraPosition = picture["camera"]["position"]
    view.CameraFocalPoint = picture["camera"]["focus"]
    view.CameraViewUp = picture["camera"]["up"]
    view.CameraViewAngle = picture["camera"]["angle"]
    display = simple.Show(volume, view)
    display.SetRepresentationType(REPRESENTATION)
    simple.ColorBy(display, picture["color_by"], separate=True)
    display.SetScalarBarVisibility(view, False)
    colors = display.LookupTable
    colors.RGBPoints = [number for row in picture["colors"] for number in row]
    colors.ColorSpace = "RGB"
    opacities = display.ScalarOpacityFunction
    opacities.Points = [number for row in picture["opacities"] for number in (*row, 0.5, 0.0)]
    display.IntervalOpacityUnitDistance = picture["unit"]
    display.IntervalBlendMode = picture["blend"]
    display.IntervalSortMode = picture["sort"]
    display.IntervalIntegrationMode = picture["integration"]
    display.IntervalRenderPath = picture["path"]
    display.IntervalDeltaTArrayName = picture["delta_t"]
    display.IntervalLayerPriorities = [str(number) for row in picture["priorities"] for number in row]
    simple.SaveScreenshot(path, view, ImageResolution=picture["size"])
    simple.Delete(view)  # while its window still has a display
    simple.Delete(volume)


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return values[:, :3].astype(int)


def main():
    load_plugin()
    checks = Checks()
    with open(extractions_path("representation.json"), encoding="utf-8") as file:
        pictures = json.load(file)
    checks.that(len(pictures) > 1, "there are pictures to repeat")
    seen = {}
    for picture in pictures:
        name = picture["name"]
        path = os.path.join(sys.argv[1], f"TestPluginRepresentation-{name}.png")
        draw(picture, path)
        drawn, expected = pixels(path), pixels(extractions_path(name + ".png"))
        difference = numpy.abs(drawn - expected)
        shown = numpy.mean((drawn != drawn[0]).any(axis=1))
        print(f"{name}: largest {difference.max()}, mean {difference.mean():.5f}, shown {shown:.3f}")
        checks.that(difference.max() <= LARGEST_DIFFERENCE, f"{name}, every pixel")
        checks.that(difference.mean() <= LARGEST_MEAN, f"{name}, the mean")
        checks.that(shown >= SMALLEST_SHARE, f"{name} shows something")
        for other, shot in seen.items():
            change = numpy.abs(drawn - shot).mean()
            checks.that(change >= SMALLEST_CHANGE, f"{name} differs from {other}: {change}")
        seen[name] = drawn
    checks.finish()


main()
