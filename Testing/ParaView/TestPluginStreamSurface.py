# SPDX-License-Identifier: BSD-3-Clause
"""Tests the representation Stream Surface: the number of lines follows the zoom, each property changes the image,
without lines the image is that of Surface, states restore it, and missing texture coordinates are an error.

Argument: a directory for a state file.
"""

import os
import sys

import numpy
from paraview import simple

from plugin_images import color_by, load_texture, plain_view, snapshot
from plugin_testing import data_path, run, warnings_of

SIDE = 256  # of the view, in pixels


def show(source):
    """Shows a square with texture coordinates from 0 to 1 that fills the view."""
    view = plain_view()
    view.ViewSize = [SIDE, SIDE]
    display = simple.Show(source, view)
    simple.Render(view)  # The first image of a view resets the camera.
    view.CameraParallelProjection = 1
    view.CameraPosition = [0, 0, 2]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 0.5
    color_by(display, None)
    display.DiffuseColor = [1, 1, 1]
    display.SetRepresentationType("Stream Surface")
    return view, display


def count_lines(view, axis):
    """Returns the number of dark lines along the center of the image."""
    shot = snapshot(view).max(axis=1).reshape(SIDE, SIDE)
    row = shot[SIDE // 2 + 8] if axis == 0 else shot[:, SIDE // 2 + 8]
    return int(((row[:-1] >= 60) & (row[1:] < 60)).sum())


def check_zoom(checks):
    view, display = show(simple.Plane())
    for side in (64, 128, 256):
        view.CameraParallelScale = 0.5 * SIDE / side
        count = count_lines(view, 0)
        checks.that(abs(count - side / 16) <= 1, f"{count} streamlines over {side} pixels")
    display.Streamlines = 0
    display.Timelines = 1
    checks.that(abs(count_lines(view, 1) - SIDE / 16) <= 1, "timelines")
    checks.that(count_lines(view, 0) == 0, "no streamlines")


def check_colors(checks):
    """Tests that lines remain if an array is shown, whose colors ParaView looks up in a texture by default."""
    view, display = show(simple.Elevation(Input=simple.Plane()))
    color_by(display, ["POINTS", "Elevation"])
    display.SetScalarBarVisibility(view, False)
    count = count_lines(view, 0)
    checks.that(abs(count - SIDE / 16) <= 1, f"{count} streamlines on colors")
    checks.that(count_lines(view, 1) == 0, "no timelines on colors")


def check_properties(checks):
    view, display = show(simple.Plane())
    display.Timelines = 1
    changes = {}
    for kind in ("Streamline", "Timeline"):
        changes.update({
            f"NumberOf{kind}s": 4, f"{kind}Distance": 40, f"{kind}Width": 0.6, f"{kind}Offset": 0.3,
            f"{kind}Color": [1, 0, 0], f"{kind}Background": [0.5, 1, 1, 1], f"{kind}s": 0})
    before = snapshot(view)
    for name, value in changes.items():
        default = getattr(display, name)
        default = list(default) if hasattr(default, "__len__") else default
        setattr(display, name, value)
        checks.that(numpy.abs(snapshot(view) - before).mean() > 0.5, f"{name} changes the image")
        setattr(display, name, default)
        checks.that((snapshot(view) == before).all(), f"{name} is restored")
    display.Texture = load_texture(data_path(os.path.join("Baseline", "flow-disk.png")))
    over = snapshot(view)
    checks.that(numpy.abs(over - before).mean() > 5, "an image is seen below the lines")
    display.Streamlines = display.Timelines = 0
    checks.that(numpy.abs(over - snapshot(view)).mean() > 5, "lines are seen over an image")
    display.Texture = None
    off = snapshot(view)
    display.SetRepresentationType("Surface")
    checks.that((snapshot(view) == off).all(), "without lines, the image is that of Surface")


def check_state(checks, directory):
    simple.ResetSession()
    view, display = show(simple.Plane())
    display.Timelines = 1
    display.TimelineColor = [1, 0, 0]
    display.NumberOfStreamlines = 8
    before = snapshot(view)
    file = os.path.join(directory, "TestPluginStreamSurface.pvsm")
    simple.SaveState(file)
    simple.ResetSession()
    simple.LoadState(file)
    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.GetRepresentation(next(iter(simple.GetSources().values())), view)
    checks.that(display.Representation == "Stream Surface" and display.NumberOfStreamlines == "8",
                "restored properties")
    checks.that((snapshot(view) == before).all(), "the image of a restored state")


def check_errors(checks):
    wavelet = simple.Wavelet()
    contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150])
    view = plain_view()
    display = simple.Show(contour, view)
    display.SetRepresentationType("Stream Surface")
    with warnings_of(display.GetClientSideObject().GetActiveRepresentation(), ("ErrorEvent",)) as errors:
        shot = snapshot(view)
    checks.that(len(errors) == 1 and "need texture coordinates" in errors[0], f"an error without coordinates: {errors}")
    display.SetRepresentationType("Surface")
    checks.that((snapshot(view) == shot).all(), "the surface without lines")


def main(checks):
    check_zoom(checks)
    check_colors(checks)
    check_properties(checks)
    check_errors(checks)
    check_state(checks, sys.argv[1])


run(main)
