# SPDX-License-Identifier: BSD-3-Clause
"""Tests that pieces of a volume on several processes shadow each other: the image must be close to the image of
one process, and much closer than with shadows that end at the borders of pieces. Also tests an image with a direction
matrix.

Arguments: `write` or `compare`, and the file with the images of one process.
"""

import sys

import numpy
from paraview import simple

from plugin_images import plain_view, snapshot
from plugin_testing import run

WHITE = [1.0, 1.0, 1.0]
LIGHTS = {"parallel": ("Directional", [3.0, 10.0, 6.0]), "point": ("Positional", [12.0, 40.0, 24.0]),
          "turned": ("Directional", [3.0, 10.0, 6.0])}
# A rotation by 90 degrees about z with a reflection, of an image whose sizes along x and y differ.
ROTATE = """
image = self.GetOutputDataObject(0)
image.ShallowCopy(self.GetInputDataObject(0, 0))
image.SetSpacing(0.6, 1.0, 1.0)
image.SetOrigin(2.0, -1.0, 0.0)
image.SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0)
"""
# Limits of the mean difference from the image of one process: with the extinction grid of all pieces, in steps of
# 1/255, and relative to the mean difference without the grid.
LARGEST_MEAN = 1.0
LARGEST_FRACTION = 0.25


def make_view(kind, position):
    view = plain_view()
    view.UseLight = False
    light = simple.AddLight(view=view)
    light.Coords = "Scene"
    light.Type = kind
    light.Position = position
    light.FocalPoint = [0.0, 0.0, 0.0]
    view.CameraPosition = [20.0, 15.0, 60.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    return view


def show(source, view):
    """Shows white smoke with varying density."""
    display = simple.Show(source, view)
    display.SetRepresentationType("Shadowed Slices")
    simple.ColorBy(display, ["POINTS", "RTData"])
    lowest, highest = 40.0, 280.0
    display.LookupTable.RGBPoints = [lowest, *WHITE, highest, *WHITE]
    display.ScalarOpacityFunction.Points = [lowest, 0.02, 0.5, 0.0, highest, 0.25, 0.5, 0.0]
    display.ShadowedOpacityUnitDistance = 1.0
    display.ShadowedShade = False
    display.AutoAdjustSampleDistances = False
    display.Opacity = 1.0
    return display


def main(checks):
    source = simple.Wavelet()
    source.UpdatePipeline()
    rotated = simple.ProgrammableFilter(Input=source, Script=ROTATE)
    pictures = {}
    for name, (kind, position) in LIGHTS.items():
        view = make_view(kind, position)
        display = show(rotated if name == "turned" else source, view)
        for size in (64, 0):
            display.ShadowGridResolution = size
            pictures[f"{name}-{size}"] = snapshot(view)
        simple.Delete(view)
    if sys.argv[1] == "write":
        numpy.savez(sys.argv[2], **pictures)
        for name in LIGHTS:
            equal = (pictures[f"{name}-64"] == pictures[f"{name}-0"]).all()
            checks.that(equal, f"{name}, with one process the grid has no effect")
    else:
        complete = numpy.load(sys.argv[2])
        for name in LIGHTS:
            differences = [numpy.abs(pictures[f"{name}-{size}"] - complete[f"{name}-64"]) for size in (64, 0)]
            with_grid, without = (difference.mean() for difference in differences)
            print(f"{name}: mean {with_grid:.4f}, {without:.4f} without the grid; largest", differences[0].max(),
                  differences[1].max())
            checks.that(with_grid <= LARGEST_MEAN, f"{name}: {with_grid} with the grid")
            checks.that(with_grid <= LARGEST_FRACTION * without, f"{name}: {with_grid} of {without}")


run(main)
