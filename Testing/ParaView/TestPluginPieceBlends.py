# SPDX-License-Identifier: BSD-3-Clause
"""Tests that images of pieces on several processes equal the images of one process, in every blend mode.

Each process renders its piece. Composite blending uses the order of the pieces. The other modes are independent of
the order and are summed before the final image. The scenes have adjacent pieces, point and cell colors, an extent
in time, and an opaque surface in all pieces. Shadowed Slices is compared without shading and shadows, which
TestPluginPieceShadows compares.

Arguments: `write` or `compare`, and the file with the images of one process.
"""

import sys

import numpy
from paraview import servermanager, simple

from plugin_images import color_by, fraction_shown, look_at, plain_view, snapshot
from plugin_testing import (
    can_exchange_data, interval_volume, open_data, run, set_properties, temporal_source, time_varying_volume,
    warnings_of)

REPRESENTATION = "Interval Volume"
ORDERED = "Composite"
BLENDS = (ORDERED, "Maximum", "Additive", "Priority", "Optical Depth", "Automatic")
# Largest allowed difference of a pixel, in steps of 1/255.
LARGEST = 2
# Shadowed Slices composites four images that are already rounded to 1/255. Up to 28 of 90,000 pixels differed
# by 3, as in Composite mode with OpenGL.
LARGEST_OF_LAYERS = 3
MAXIMUM_PIXELS_OF_LAYERS = 50
SMALLEST_FRACTION = 0.1  # fraction of pixels that differ from the background
FIELD = {"WholeExtent": [0, 23, 0, 19, 0, 19], "Bounds": [-0.5, 0.5, -0.4, 0.4, -0.4, 0.4]}
IN_TIME = {"Intervals": [0.1, 0.4, 0.4, 0.9]}
SLICES = {
    "ShadowedOpacityUnitDistance": 4.0, "ShadowedShade": False, "Shadows": False,
    "AutoAdjustSampleDistances": False, "Opacity": 1.0}
# The cropped box of all pieces ends within pieces and crosses their borders.
CROPPED = {
    "ShadowedUseCropping": 1, "ShadowedCroppingOrigin": [1.0, 0.5, -1.0],
    "ShadowedCroppingScale": [0.6, 0.7, 0.8]}
WAVELET_INTERVALS = [(100.0, 140.0), (140.0, 180.0), (180.0, 230.0)]


def wavelet_intervals():
    return interval_volume(open_data("wavelet"), "RTData", WAVELET_INTERVALS)


def corner_intervals():
    """Only one of the pieces has cells."""
    corner = simple.Clip(Input=open_data("wavelet"), Invert=True)
    corner.ClipType.Origin = [-6.0, -6.0, -6.0]
    corner.ClipType.Normal = [1.0, 1.0, 1.0]
    corner.UpdatePipeline()
    return interval_volume(corner, "RTData", [(40.0, 100.0), (100.0, 180.0)])


def intervals_in_time():
    return time_varying_volume(temporal_source("AnalyticField", FIELD), IN_TIME)


# By name: function for the volume, array for coloring, range of its colors, unit distance of the opacity,
# radius of an enclosed sphere, and whether tetrahedra overlap, so that no order exists.
SCENES = {
    "points": (wavelet_intervals, ["POINTS", "RTData"], (100.0, 230.0), 4.0, 0.0, False),
    "cells": (wavelet_intervals, ["CELLS", "IntervalId"], (0.0, 2.0), 4.0, 0.0, False),
    "solid": (wavelet_intervals, None, None, 8.0, 0.0, False),
    "surface": (wavelet_intervals, ["POINTS", "RTData"], (100.0, 230.0), 4.0, 6.0, False),
    "corner": (corner_intervals, ["POINTS", "RTData"], (40.0, 180.0), 2.0, 0.0, False),
    "in time": (intervals_in_time, ["CELLS", "IntervalId"], (0.0, 1.0), 0.02, 0.0, True),
}


def set_functions(display, ends):
    lowest, highest = ends
    center = 0.5 * (lowest + highest)
    display.LookupTable.ColorSpace = "RGB"
    display.LookupTable.RGBPoints = [lowest, 0.1, 0.2, 0.9, center, 0.2, 0.8, 0.3, highest, 0.9, 0.3, 0.1]
    opacities = [lowest, 0.1, 0.5, 0.0, center, 0.6, 0.5, 0.0, highest, 0.3, 0.5, 0.0]
    display.ScalarOpacityFunction.Points = opacities


def make_view():
    view = plain_view()
    view.UseFXAA = False  # it amplifies steps of 1/255 that are at its threshold
    return view


def draw_empty():
    """Renders a volume without cells."""
    volume = interval_volume(open_data("wavelet"), "RTData", [(1000.0, 1001.0)])
    with warnings_of(volume):
        volume.UpdatePipeline()
    view = make_view()
    display = simple.Show(volume, view)
    display.SetRepresentationType(REPRESENTATION)
    shots = []
    for blend in BLENDS:
        display.IntervalBlendMode = blend
        shots.append(snapshot(view))
    simple.Delete(view)
    return numpy.array(shots)


def draw_slices(settings):
    view = make_view()
    display = simple.Show(open_data("wavelet"), view)
    display.SetRepresentationType("Shadowed Slices")
    color_by(display, ["POINTS", "RTData"])
    display.SetScalarBarVisibility(view, False)
    set_functions(display, (40.0, 280.0))
    set_properties(display, {**SLICES, **settings})
    look_at(view)
    shot = snapshot(view)
    simple.Delete(view)
    return shot


def draw(scene):
    """Returns the images of a scene by blend mode, each with the warnings of the representation."""
    make, array, ends, unit, radius, _ = scene
    volume = make()
    view = make_view()
    if radius > 0.0:
        simple.Show(simple.Sphere(Radius=radius, ThetaResolution=40, PhiResolution=40), view)
    display = simple.Show(volume, view)
    display.SetRepresentationType(REPRESENTATION)
    color_by(display, array)
    if array:
        display.SetScalarBarVisibility(view, False)
        set_functions(display, ends)
    set_properties(display, {"IntervalOpacityUnitDistance": unit, "Opacity": 1.0})
    look_at(view)
    shots = {}
    with warnings_of(display.GetClientSideObject().GetActiveRepresentation()) as messages:
        for blend in BLENDS:
            before = len(messages)
            display.IntervalBlendMode = blend
            shots[blend] = snapshot(view), messages[before:]
    simple.Delete(view)
    return shots


def compare(checks, name, shot, expected, are_layers=False):
    difference = numpy.abs(shot - expected).max(axis=1)
    above = numpy.count_nonzero(difference > LARGEST)
    print(f"{name}: largest {difference.max()}, 99.9 % {numpy.quantile(difference, 0.999):.0f},",
          f"mean {difference.mean():.4f}, above {LARGEST}/255: {above} of {len(difference)}", flush=True)
    checks.that(difference.max() <= (LARGEST_OF_LAYERS if are_layers else LARGEST), f"{name}, every pixel")
    checks.that(above <= MAXIMUM_PIXELS_OF_LAYERS, f"{name}, number of pixels above {LARGEST}/255")


def main(checks):
    mode, path = sys.argv[1:]
    ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    complete = numpy.load(path) if mode == "compare" else {}
    found = {}
    checks.equal(ranks > 1, mode == "compare", "comparing needs several processes")
    for scene, values in SCENES.items():
        # The processes must send the opaque surface to each other.
        if mode == "compare" and values[4] > 0.0 and not can_exchange_data():
            print(f"{scene}: not compared, this ParaView cannot exchange grids", flush=True)
            continue
        for blend, (shot, messages) in draw(values).items():
            name = f"{scene}, {blend}"
            found[name] = shot
            checks.that(fraction_shown(shot) >= SMALLEST_FRACTION, f"{name} is visible")
            if mode == "compare" and values[-1] and blend == ORDERED:
                checks.one_message(messages, "overlap and have no order", name)
                continue
            checks.equal(messages, [], f"{name}, warnings")
            if mode == "compare":
                compare(checks, name, shot, complete[name])
    checks.equal(draw_empty().max(), 0, "largest channel for a volume without cells")
    for name, settings in {"slices": {}, "cropped slices": CROPPED}.items():
        found[name] = draw_slices(settings)
        checks.that(fraction_shown(found[name]) >= SMALLEST_FRACTION, f"{name} are visible")
        if mode == "compare":
            compare(checks, name, found[name], complete[name], True)
    if mode == "write":
        numpy.savez(path, **found)


run(main)
