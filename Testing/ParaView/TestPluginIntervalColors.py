# SPDX-License-Identifier: BSD-3-Clause
"""Colours and opacities that a representation of the plugin begins with: an interval has a colour of its
own, and is seen; so is an array with one value; Opacity thins what is drawn."""

import numpy
from paraview import simple

from plugin_pictures import (
    VIEW_SIZE, add_array, color_by, coordinates, grid, image, plain_view, producer, share_shown, snapshot)
from plugin_testing import interval_volume, open_file, run

SIDE = 13
INTERVALS = 4
# The hues of the first intervals: blue, orange, green, red.
LARGEST_CHANNEL = (2, 0, 1, 0)
# Each is drawn as densely as the first.
DENSITY_TOLERANCE = 0.02
KINDS = (("Shadowed Slices", image), ("Interval Volume", grid))


def layers(number):
    """A cube with so many layers along x, an interval each."""
    data = grid(SIDE)
    middles = numpy.array([data.GetCell(i).GetBounds()[:2] for i in range(data.GetNumberOfCells())]).mean(axis=1)
    ids = numpy.floor(middles / (SIDE - 1) * number).astype(numpy.int32)
    add_array(data, "IntervalId", ids, False)
    return data


def show(source, kind):
    """From the front, x to the right, filling the picture's width."""
    view = plain_view()
    display = simple.Show(source, view)
    display.SetRepresentationType(kind)
    simple.Render(view)  # places the camera, the first time
    middle = (SIDE - 1) / 2
    view.CameraParallelProjection = True
    view.CameraParallelScale = middle
    view.CameraPosition = [middle, middle, 10 * SIDE]
    view.CameraFocalPoint = [middle, middle, middle]
    return view, display


def bands(view, number):
    """The mean colour of each of so many columns of the picture, without their seams."""
    shot = snapshot(view).reshape(VIEW_SIZE[1], VIEW_SIZE[0], 3)
    width = VIEW_SIZE[0] // number
    margin = width // 4
    return [shot[100:200, i * width + margin:(i + 1) * width - margin].mean(axis=(0, 1)) for i in range(number)]


def depth(display, value):
    """The opacity that the function has for a value."""
    function = display.ScalarOpacityFunction.GetClientSideObject()
    return function.GetValue(value)


def check_ids(checks):
    source = producer(layers(INTERVALS))
    view, display = show(source, "Interval Volume")
    color_by(display, ["CELLS", "IntervalId"])
    colors = bands(view, INTERVALS)
    for i, color in enumerate(colors):
        checks.that(color.max() > 40, f"interval {i} is seen: {color}")
        checks.equal(int(numpy.argmax(color)), LARGEST_CHANNEL[i], f"interval {i}, hue of {color}")
        checks.close(depth(display, i), depth(display, 0), DENSITY_TOLERANCE, f"interval {i}, opacity")
        for j in range(i):
            checks.that(numpy.abs(color - colors[j]).max() > 30, f"intervals {i} and {j} differ")
    checks.equal(list(display.LookupTable.Annotations)[::2], [str(i) for i in range(INTERVALS)], "legend")

    # A rescale, as the client's button does, leaves each its colour.
    display.RescaleTransferFunctionToDataRange(False, True)
    for i, color in enumerate(bands(view, INTERVALS)):
        checks.that(numpy.abs(color - colors[i]).max() < 2, f"interval {i} after rescaling: {color}")

    # More of them than at first.
    more = INTERVALS + 2
    source.GetClientSideObject().SetOutput(layers(more))
    source.SMProxy.MarkModified(source.SMProxy)
    source.UpdatePipeline()
    snapshot(view)
    found = bands(view, more)
    for i, color in enumerate(found):
        checks.that(color.max() > 40, f"interval {i} of {more} is seen: {color}")
        for j in range(i):
            checks.that(numpy.abs(color - found[j]).max() > 15, f"intervals {i} and {j} of {more} differ")

    # What a user sets holds.
    display.LookupTable.RGBPoints = [0.0, 1.0, 0.0, 0.0, more - 1.0, 0.0, 0.0, 1.0]
    display.ScalarOpacityFunction.Points = [0.0, 1.0, 0.5, 0.0, more - 1.0, 1.0, 0.5, 0.0]
    display.Representation = "Surface"
    display.Representation = "Interval Volume"
    first, last = bands(view, more)[0], bands(view, more)[-1]
    checks.that(first[0] > 200 and first[2] < 5, f"red as set: {first}")
    checks.that(last[2] > 200 and last[0] < 5, f"blue as set: {last}")
    simple.Delete(view)


def check_filter(checks):
    """The filter's output, its cells by interval."""
    source = open_file("disk_out_ref.vtu")
    volume = interval_volume(source, "Temp", [(300.0, 400.0), (500.0, 600.0), (700.0, 850.0)])
    view = plain_view()
    display = simple.Show(volume, view)
    display.SetRepresentationType("Interval Volume")
    color_by(display, ["CELLS", "IntervalId"])
    simple.ResetCamera(view)
    shares = []
    for kept in range(3):
        alone = simple.Threshold(Input=volume, Scalars=["CELLS", "IntervalId"], ThresholdMethod="Between",
                                 LowerThreshold=kept, UpperThreshold=kept)
        simple.Hide(volume, view)
        part = simple.Show(alone, view)
        part.SetRepresentationType("Interval Volume")
        color_by(part, ["CELLS", "IntervalId"])
        shares.append(share_shown(snapshot(view)))
        simple.Hide(alone, view)
    print("shares of the intervals alone:", shares)
    checks.that(min(shares) > 0.05, f"each interval alone is seen: {shares}")
    simple.Delete(view)


def check_constant(checks):
    """One value, whatever it is."""
    for kind, make in KINDS:
        for value in (0.0, 5.0, -3.0, 1e6):
            data = make(SIDE)
            name = f"constant {value}"  # functions are by name
            add_array(data, name, numpy.full(data.GetNumberOfPoints(), value))
            view, display = show(producer(data), kind)
            share = share_shown(snapshot(view))
            checks.that(share > 0.9, f"{kind}, constant {value}: {share} of the picture")
            checks.equal(display.ColorArrayName.GetArrayName(), name, f"{kind}, constant, array")
            simple.Delete(view)


def check_opacity(checks):
    """It thins the volume, with an array and without, and at 1 is as if it were not there."""
    for kind, make in KINDS:
        data = make(SIDE)
        add_array(data, "value", coordinates(data)[:, 0])
        view, display = show(producer(data), kind)
        for array in (["POINTS", "value"], None):
            color_by(display, array)
            brightness = []
            for opacity in (1.0, 0.5, 0.1, 0.0):
                display.Opacity = opacity
                brightness.append(snapshot(view).mean())
            checks.that(brightness[0] > brightness[1] > brightness[2] > brightness[3],
                        f"{kind}, by {array}, Opacity thins: {brightness}")
            checks.equal(brightness[3], 0.0, f"{kind}, by {array}, Opacity 0")
            display.Opacity = 1.0
            checks.equal(snapshot(view).mean(), brightness[0], f"{kind}, by {array}, Opacity 1 again")
        simple.Delete(view)


def main(checks):
    check_ids(checks)
    check_filter(checks)
    check_constant(checks)
    check_opacity(checks)


run(main)
