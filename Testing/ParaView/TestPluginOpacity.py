# SPDX-License-Identifier: BSD-3-Clause
"""Tests the default opacity of Shadowed Slices: every image in Data/ is legible, and functions of the user remain.

Arguments: write or compare, and a file. Write tests one process and writes the opacity functions to the file.
Compare checks that several processes estimate the same functions.
"""

import sys

import numpy
from paraview import simple

from plugin_images import add_array, coordinates, image, look_at, plain_view, producer, snapshot
from plugin_testing import manifest_arrays, open_file, run

SIZE = [200, 200]
DARK, BRIGHT = 12, 250  # of 255; darker pixels are background, and brighter ones are saturated
LEGIBLE = (0.08, 0.8)  # fraction of the box's pixels that show the data
SMALLEST_CONTRAST = 12  # standard deviation of the brightness of these pixels
PIECES = ["neghip.vti", "tooth.vti"]
PIECES_TOLERANCE = 0.03  # pieces share samples at their borders


def images():
    """Returns the files with images in three dimensions; earth.vti is a map."""
    return [name for name in manifest_arrays()
            if name != "earth.vti" and (name.endswith(".vti") or name == "ironProt.vtk")]


def show(source, array=None):
    view = plain_view()
    view.ViewSize = SIZE
    display = simple.Show(source, view)
    if array:
        simple.ColorBy(display, ["POINTS", array])
        display.SetScalarBarVisibility(view, False)
    display.SetRepresentationType("Shadowed Slices")
    simple.Render(view)
    return view, display


def opacities(display):
    """Returns rows of value and opacity."""
    return numpy.array(display.ScalarOpacityFunction.Points).reshape(-1, 4)[:, :2]


def is_legible(view, display, name):
    """Returns whether the data are seen in a part of their box."""
    look_at(view)
    shot = snapshot(view).max(axis=1)
    display.SetRepresentationType("Surface")
    box = snapshot(view).max(axis=1) > DARK
    display.SetRepresentationType("Shadowed Slices")
    seen = box & (shot > DARK) & (shot < BRIGHT)
    fraction = seen.sum() / box.sum()
    contrast = shot[seen].std() if seen.any() else 0
    print(f"{name}: {fraction:.3f} of the box, contrast {contrast:.1f}", flush=True)
    return LEGIBLE[0] <= fraction <= LEGIBLE[1] and contrast >= SMALLEST_CONTRAST


def check_images(checks, file):
    functions = {}
    for name in images():
        view, display = show(open_file(name))
        functions[name] = opacities(display)
        checks.that(is_legible(view, display, name), f"{name} is legible")
        if name in ("tooth.vti", "isabel_pressure_sub100.vti"):
            low, high = functions[name][[0, -1], 0]
            display.ScalarOpacityFunction.Points = [low, 0, 0.5, 0, high, 1, 0.5, 0]
            checks.that(not is_legible(view, display, name + " with ParaView's default"),
                        f"{name} is not legible with ParaView's default")
        simple.ResetSession()  # images share the functions of arrays of the same name
    numpy.savez(file, **functions)


def check_user(checks):
    """Tests that functions of the user, and a ramp set after the estimate, remain."""
    data = image(20)
    add_array(data, "value", numpy.exp(-coordinates(data)[:, 0]))
    view, display = show(producer(data), "value")
    low, high = opacities(display)[[0, -1], 0]
    checks.that(len(opacities(display)) > 2, "the default is replaced")
    ramp = [low, 0, 0.5, 0, high, 1, 0.5, 0]
    for points in (ramp, [low, 0.5, 0.5, 0, high, 0.7, 0.5, 0]):
        display.ScalarOpacityFunction.Points = points
        for representation in ("Surface", "Shadowed Slices"):
            display.SetRepresentationType(representation)
            simple.Render(view)
        checks.equal(list(display.ScalarOpacityFunction.Points), points, "the user's function")
    simple.Delete(view)
    view, display = show(producer(data), "value")  # uses the same function
    checks.equal(list(display.ScalarOpacityFunction.Points), points, "the user's function in another view")
    simple.Delete(view)


def check_state(checks, file):
    """Tests that a ramp in a state file remains."""
    view, display = show(open_file("neghip.vti"))
    points = [0, 0, 0.5, 0, 255, 1, 0.5, 0]
    display.ScalarOpacityFunction.Points = points
    state = file + ".pvsm"
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadState(state)
    view = simple.GetRenderViews()[0]
    for brightness in (0.5, 1.0):
        display = view.Representations[0]
        display.Opacity = brightness
        simple.Render(view)
    checks.equal(list(display.ScalarOpacityFunction.Points), points, "the state's function")
    simple.Delete(view)


def check_arrays(checks):
    """Tests the magnitude of vectors, and cells."""
    data = image(20)
    random = numpy.random.default_rng(1)
    vectors = numpy.zeros((20 ** 3, 3))
    vectors[:, 1] = -numpy.where(coordinates(data)[:, 0] > 15, random.uniform(20, 25, 20 ** 3),
                                 random.uniform(0, 0.5, 20 ** 3))
    add_array(data, "vectors", vectors)
    add_array(data, "cells", -vectors[:19 ** 3, 1], False)
    for kind, name in (("POINTS", "vectors"), ("CELLS", "cells")):
        view = plain_view()
        display = simple.Show(producer(data), view)
        simple.ColorBy(display, [kind, name])
        display.SetRepresentationType("Shadowed Slices")
        simple.Render(view)
        function = display.ScalarOpacityFunction.GetClientSideObject()
        checks.equal(function.GetValue(0.25), 0.0, f"{name}, background")
        checks.that(function.GetValue(22.5) > 0.1, f"{name}, foreground: {function.GetValue(22.5)}")
        simple.Delete(view)


def check_pieces(checks, file):
    expected = numpy.load(file)
    for name in PIECES:
        _, display = show(open_file(name))
        found = opacities(display)
        width = found[-1, 0] - found[0, 0]
        checks.equal(found.shape, expected[name].shape, f"{name}, number of points")
        if found.shape == expected[name].shape:
            error = numpy.abs(found - expected[name]).max(axis=0) / [width, 1.0]
            checks.that(error.max() <= PIECES_TOLERANCE, f"{name}, function: {error}")
        simple.ResetSession()


def main(checks):
    mode, file = sys.argv[1:]
    if mode == "compare":
        check_pieces(checks, file)
        return
    check_images(checks, file)
    check_user(checks)
    check_arrays(checks)
    check_state(checks, file)


run(main)
