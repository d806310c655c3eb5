# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of a volume on several processes shadow each other: the picture is nearly that of one process,
and much nearer than with shadows that end at the pieces' borders. Also where a direction matrix turns the image.

Arguments: `write` or `compare`, and the file of the pictures of one process."""

import sys

import numpy
from paraview import simple

from plugin_pictures import plain_view, snapshot
from plugin_testing import run

WHITE = [1.0, 1.0, 1.0]
LIGHTS = {"parallel": ("Directional", [3.0, 10.0, 6.0]), "point": ("Positional", [12.0, 40.0, 24.0]),
          "turned": ("Directional", [3.0, 10.0, 6.0])}
# A quarter turn about z and a reflection, of an image that is not as long along x as along y.
TURN = """
image = self.GetOutputDataObject(0)
image.ShallowCopy(self.GetInputDataObject(0, 0))
image.SetSpacing(0.6, 1.0, 1.0)
image.SetOrigin(2.0, -1.0, 0.0)
image.SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0)
"""
# The mean difference to one process in steps of 1/255 with the grid, and what it is at most of that without.
LARGEST_MEAN = 1.0
LARGEST_SHARE = 0.25


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
    """Smoke whose density varies, as white as its light."""
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
    turned = simple.ProgrammableFilter(Input=source, Script=TURN)
    pictures = {}
    for name, (kind, position) in LIGHTS.items():
        view = make_view(kind, position)
        display = show(turned if name == "turned" else source, view)
        for size in (64, 0):
            display.ShadowGridResolution = size
            pictures[f"{name}-{size}"] = snapshot(view)
        simple.Delete(view)
    if sys.argv[1] == "write":
        numpy.savez(sys.argv[2], **pictures)
        for name in LIGHTS:
            equal = (pictures[f"{name}-64"] == pictures[f"{name}-0"]).all()
            checks.that(equal, f"{name}, one process: the grid changes nothing")
    else:
        whole = numpy.load(sys.argv[2])
        for name in LIGHTS:
            differences = [numpy.abs(pictures[f"{name}-{size}"] - whole[f"{name}-64"]) for size in (64, 0)]
            with_grid, without = (difference.mean() for difference in differences)
            print(f"{name}: mean {with_grid:.4f}, {without:.4f} without the grid; largest", differences[0].max(),
                  differences[1].max())
            checks.that(with_grid <= LARGEST_MEAN, f"{name}: {with_grid} with the grid")
            checks.that(with_grid <= LARGEST_SHARE * without, f"{name}: {with_grid} of {without}")


run(main)
