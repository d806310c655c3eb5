# SPDX-License-Identifier: BSD-3-Clause
"""Tests random sequences of changes of arrays, representations, blocks, opacity, colors and visibility. The
image must equal that of a new display with the same settings."""

import random

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

from plugin_images import add_array, color_by, coordinates, grid, image, plain_view, producer, snapshot
from plugin_testing import run

SEQUENCES = 6
STEPS = 12
OF_POINTS = (None, ["POINTS", "scalars"], ["POINTS", "vectors"], ["POINTS", "constant"])
ARRAYS = (*OF_POINTS, ["CELLS", "IntervalId"])
CHOICES = {
    "Opacity": (1.0, 0.4), "DiffuseColor": ([1.0, 1.0, 1.0], [0.2, 0.9, 0.4]), "Visibility": (1, 0)}
OF_IMAGES = {
    "array": OF_POINTS, "ShadowedUseSeparateOpacityArray": (0, 1),
    "ShadowedOpacityArrayName": (["POINTS", "scalars"], ["POINTS", "constant"]),
    "ShadowedUseCropping": (0, 1), "ColoredShadows": (0, 1)}
OF_GRIDS = {"MapScalars": (1, 0)}
OF_BLOCKS = {"BlockSelectors": (["/"], ["/Root/Block0"])}


def arrays_of(data):
    points = coordinates(data)
    add_array(data, "scalars", points[:, 0] + 0.2 * points[:, 1] ** 2)
    add_array(data, "vectors", points)
    add_array(data, "constant", numpy.full(len(points), 2.0))
    ids = numpy.arange(data.GetNumberOfCells()) * 3 // data.GetNumberOfCells()
    add_array(data, "IntervalId", ids.astype(numpy.int32), False)
    return data


def blocks():
    data = vtkMultiBlockDataSet()
    for i in range(2):
        data.SetBlock(i, arrays_of(grid(4, (3.0 * i, 0.0, 0.0))))
    return data


# Name, data, representations (the last one is compared), and possible values of further properties.
CASES = (
    ("image", lambda: arrays_of(image(6)), ("Outline", "Surface", "Volume", "Shadowed Slices"), OF_IMAGES),
    ("grid", lambda: arrays_of(grid(5)), ("Outline", "Surface", "Volume", "Interval Volume"), OF_GRIDS),
    ("blocks", blocks, ("Surface", "Volume", "Interval Volume"), OF_BLOCKS))


def set_value(display, name, value):
    if name == "array":
        color_by(display, value)
    elif name == "Representation":
        display.SetRepresentationType(value)
    else:
        setattr(display, name, value)


def shot_of(view):
    simple.ResetCamera(view)
    view.GetActiveCamera().Azimuth(30)
    return snapshot(view)


def check(checks, name, source, kinds, choices, seed):
    generator = random.Random(seed)
    options = {"array": ARRAYS, "Representation": kinds, **CHOICES, **choices}
    last = {name: values[0] for name, values in options.items()}
    view = plain_view()
    display = simple.Show(source, view)
    display.SetRepresentationType(kinds[-1])
    for _ in range(STEPS):
        key = generator.choice(list(options))
        last[key] = generator.choice(options[key])
        set_value(display, key, last[key])
        if generator.random() < 0.5:
            simple.Render(view)
    last["array"] = generator.choice(options["array"])
    last["Representation"], last["Visibility"] = kinds[-1], 1
    for key, value in last.items():
        set_value(display, key, value)
    set_value(display, "array", last["array"])
    found = shot_of(view)
    simple.Delete(view)

    view = plain_view()
    display = simple.Show(source, view)
    for key in ("Representation", *options, "array"):  # setting the array sets the range of the functions
        set_value(display, key, last[key])
    expected = shot_of(view)
    simple.Delete(view)
    difference = int(numpy.abs(found - expected).max())
    checks.equal(difference, 0, f"{name}, sequence {seed}, {last}")
    checks.that(expected.max() > 0, f"{name}, sequence {seed}, is visible, {last}")


def main(checks):
    for name, make, kinds, choices in CASES:
        source = producer(make())
        for seed in range(SEQUENCES):
            check(checks, name, source, kinds, choices, seed)


run(main)
