# SPDX-License-Identifier: BSD-3-Clause
"""Tests that a representation of the plugin never shows an empty view: it selects an array for coloring, or
uses the solid color.

Argument: a directory for a state file.
"""

import os
import sys

import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIdTypeArray, vtkStringArray

from plugin_images import (
    add_array, color_by, coordinates, fraction_shown, grid, image, look_at, plain_view, producer,
    snapshot)
from plugin_testing import open_data, open_file, run

SMALLEST_FRACTION = 0.05
KINDS = (("Shadowed Slices", image), ("Interval Volume", grid))


def show(data, kind, by_method=True):
    """Shows the data first as an outline without colors, then in the representation."""
    view = plain_view()
    display = simple.Show(producer(data), view)
    display.SetRepresentationType("Outline")
    color_by(display, None)
    if by_method:
        display.SetRepresentationType(kind)
    else:
        display.Representation = kind
    look_at(view)
    return view, display


def colored_by(display):
    return (display.ColorArrayName.GetAssociation(), display.ColorArrayName.GetArrayName() or "")


def radius(data):
    points = coordinates(data)
    return numpy.linalg.norm(points - points.mean(axis=0), axis=1)


def check_shown(checks, view, what):
    fraction = fraction_shown(snapshot(view))
    print(f"{what}: {fraction:.3f} of the image")
    checks.that(fraction >= SMALLEST_FRACTION, f"{what} is visible")


def check_switched_on(checks, kind, make):
    """Switches with the method that the client uses, and with the property."""
    for by_method in (True, False):
        data = make()
        add_array(data, "radius", radius(data))
        view, display = show(data, kind, by_method)
        what = f"{kind}, {'method' if by_method else 'property'}"
        checks.equal(colored_by(display), ("POINTS", "radius"), f"{what}, array")
        check_shown(checks, view, what)
        points = list(display.LookupTable.RGBPoints)
        checks.close(points[-4], radius(data).max(), 1e-6, f"{what}, range of the colors")
        simple.Delete(view)


def check_choice(checks, kind, make):
    """Tests the order of preference: arrays with a range before constant ones and ids, points before cells,
    scalars before vectors. Strings and field data are never selected."""
    data = make()
    count, cells = data.GetNumberOfPoints(), data.GetNumberOfCells()
    words = vtkStringArray()
    words.SetName("a words")
    words.SetNumberOfValues(count)
    data.GetPointData().AddArray(words)
    field = vtkFloatArray()
    field.SetName("a field")
    field.InsertNextValue(3.0)
    data.GetFieldData().AddArray(field)
    add_array(data, "a zero", numpy.zeros(count))
    view, display = show(data, kind)
    checks.equal(colored_by(display), ("POINTS", "a zero"), f"{kind}, only a constant array")
    check_shown(checks, view, f"{kind}, constant array")
    simple.Delete(view)
    ids = vtkIdTypeArray()
    ids.SetName("b ids")
    ids.SetNumberOfValues(cells)
    for i in range(cells):
        ids.SetValue(i, i)
    data.GetCellData().AddArray(ids)
    steps = (("c cells", numpy.arange(cells, dtype=float), False, "CELLS"),
             ("d vectors", coordinates(data), True, "POINTS"),
             ("e scalars", radius(data), True, "POINTS"))
    for name, values, of_points, association in steps:
        add_array(data, name, values, of_points)
        view, display = show(data, kind)
        checks.equal(colored_by(display), (association, name), f"{kind}, selected array")
        check_shown(checks, view, f"{kind}, {name}")
        simple.Delete(view)


def mean_color(shot):
    return shot[(shot != 0).any(axis=1)].mean(axis=0)


def check_solid(checks, kind, make):
    """Tests that the solid color is used if there is no array or if the user selects it."""
    view, display = show(make(), kind)
    check_shown(checks, view, f"{kind}, no array")
    checks.equal(colored_by(display)[1], "", f"{kind}, no array is selected")
    display.DiffuseColor = [1.0, 0.0, 0.0]
    red, green, blue = mean_color(snapshot(view))
    checks.that(red > 50 and green == 0 and blue == 0, f"{kind}, the solid color is red")
    simple.Delete(view)

    data = make()
    add_array(data, "radius", radius(data))
    view, display = show(data, kind)
    color_by(display, None)
    display.DiffuseColor = [0.0, 0.0, 1.0]
    red, green, blue = mean_color(snapshot(view))
    checks.that(blue > 50 and red == 0 and green == 0, f"{kind}, the solid color is blue")
    checks.equal(colored_by(display)[1], "", f"{kind}, the selected solid color is kept")
    for missing in (["POINTS", "missing"], ["CELLS", "radius"], ["FIELD", "radius"]):
        display.ColorArrayName = missing
        check_shown(checks, view, f"{kind}, by {missing}")
    simple.Delete(view)


def check_state(checks, kind, make, folder):
    """Tests that a state file restores the array or the solid color."""
    path = os.path.join(folder, f"TestPluginBlankView-{kind.replace(' ', '-')}.pvsm")
    for solid in (False, True):
        simple.ResetSession()
        source = open_data("wavelet") if make is image else open_file("disk_out_ref.vtu")
        view = plain_view()
        display = simple.Show(source, view)
        color_by(display, None)
        display.SetRepresentationType(kind)
        if solid:
            color_by(display, None)
        look_at(view)
        before, colors = snapshot(view), colored_by(display)
        simple.SaveState(path)
        simple.ResetSession()
        simple.LoadState(path)
        view = simple.GetViews(viewtype="RenderView")[0]
        display = simple.GetRepresentations()[list(simple.GetRepresentations())[0]]
        after = snapshot(view)
        checks.equal(colored_by(display), colors, f"{kind}, state, solid {solid}, array")
        checks.that(fraction_shown(after) >= SMALLEST_FRACTION, f"{kind}, state, solid {solid}, is visible")
        checks.equal(int(numpy.abs(before - after).max()), 0, f"{kind}, state, solid {solid}, pixel difference")
        simple.Delete(view)


def main(checks):
    for kind, make in KINDS:
        check_switched_on(checks, kind, make)
        check_choice(checks, kind, make)
        check_solid(checks, kind, make)
        check_state(checks, kind, make, sys.argv[1])


run(main)
