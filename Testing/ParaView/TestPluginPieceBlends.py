# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of pieces on several processes are those of one process, in every blend mode.

Each process draws its piece. Composite is put together in the order of the pieces; the other modes need no
order, and are summed up before they become a picture. Compared are pieces that fill boxes beside each other,
point and cell colours, an extent in time, and an opaque surface that stands in all pieces; and of Shadowed
Slices the one mode that it has, without shading and shadows, which TestPluginPieceShadows compares.

Arguments: `write` or `compare`, and the file of the pictures of one process."""

import sys

import numpy
from paraview import servermanager, simple

from plugin_pictures import color_by, look_at, plain_view, share_shown, snapshot
from plugin_testing import (
    can_exchange_data, interval_volume, open_data, run, set_properties, temporal_source, time_varying_volume,
    warnings_of)

REPRESENTATION = "Interval Volume"
ORDERED = "Composite"
BLENDS = (ORDERED, "Maximum", "Additive", "Priority", "Optical Depth", "Automatic")
# In steps of 1/255, each pixel.
LARGEST = 2
# Shadowed Slices lay four pictures over each other that are rounded to 1/255 before: up to 28 of 90,000 pixels
# were seen to be off by 3, as of Composite where OpenGL draws it.
LARGEST_OF_LAYERS = 3
MOST_OF_LAYERS = 50
SMALLEST_SHARE = 0.1  # of the picture that shows something
FIELD = {"WholeExtent": [0, 23, 0, 19, 0, 19], "Bounds": [-0.5, 0.5, -0.4, 0.4, -0.4, 0.4]}
IN_TIME = {"Intervals": [0.1, 0.4, 0.4, 0.9]}
SLICES = {
    "ShadowedOpacityUnitDistance": 4.0, "ShadowedShade": False, "Shadows": False,
    "AutoAdjustSampleDistances": False, "Opacity": 1.0}
# The cropped box, of all pieces together, ends within pieces and stands across their borders.
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


# Name: what is drawn, what it is coloured by with the ends of its colours, the opacity's unit, the radius of
# a sphere within, and whether tetrahedra overlap, so that no order exists.
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
    middle = 0.5 * (lowest + highest)
    display.LookupTable.ColorSpace = "RGB"
    display.LookupTable.RGBPoints = [lowest, 0.1, 0.2, 0.9, middle, 0.2, 0.8, 0.3, highest, 0.9, 0.3, 0.1]
    opacities = [lowest, 0.1, 0.5, 0.0, middle, 0.6, 0.5, 0.0, highest, 0.3, 0.5, 0.0]
    display.ScalarOpacityFunction.Points = opacities


def make_view():
    view = plain_view()
    view.UseFXAA = False  # it makes more of a step of 1/255 where that is across its threshold
    return view


def draw_nothing():
    """A volume without cells."""
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
    """The pictures of a scene, by their blend modes, each with what the representation warned of."""
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
    with warnings_of(display.GetClientSideObject().GetActiveRepresentation()) as said:
        for blend in BLENDS:
            before = len(said)
            display.IntervalBlendMode = blend
            shots[blend] = snapshot(view), said[before:]
    simple.Delete(view)
    return shots


def compare(checks, name, shot, expected, are_layers=False):
    difference = numpy.abs(shot - expected).max(axis=1)
    beyond = numpy.count_nonzero(difference > LARGEST)
    print(f"{name}: largest {difference.max()}, 99.9 % {numpy.quantile(difference, 0.999):.0f},",
          f"mean {difference.mean():.4f}, beyond {LARGEST}/255: {beyond} of {len(difference)}", flush=True)
    checks.that(difference.max() <= (LARGEST_OF_LAYERS if are_layers else LARGEST), f"{name}, every pixel")
    checks.that(beyond <= MOST_OF_LAYERS, f"{name}, pixels beyond {LARGEST}/255")


def main(checks):
    mode, path = sys.argv[1:]
    ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    whole = numpy.load(path) if mode == "compare" else {}
    found = {}
    checks.equal(ranks > 1, mode == "compare", "several processes compare")
    for scene, values in SCENES.items():
        # The processes have to send each other the opaque surface.
        if mode == "compare" and values[4] > 0.0 and not can_exchange_data():
            print(f"{scene}: not compared, this ParaView cannot exchange grids", flush=True)
            continue
        for blend, (shot, said) in draw(values).items():
            name = f"{scene}, {blend}"
            found[name] = shot
            checks.that(share_shown(shot) >= SMALLEST_SHARE, f"{name} shows something")
            if mode == "compare" and values[-1] and blend == ORDERED:
                checks.said(said, "overlap and have no order", name)
                continue
            checks.equal(said, [], f"{name}, warnings")
            if mode == "compare":
                compare(checks, name, shot, whole[name])
    checks.equal(draw_nothing().max(), 0, "what a volume without cells shows")
    for name, settings in {"slices": {}, "cropped slices": CROPPED}.items():
        found[name] = draw_slices(settings)
        checks.that(share_shown(found[name]) >= SMALLEST_SHARE, f"{name} show something")
        if mode == "compare":
            compare(checks, name, found[name], whole[name], True)
    if mode == "write":
        numpy.savez(path, **found)


run(main)
