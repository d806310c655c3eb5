# SPDX-License-Identifier: BSD-3-Clause
"""Tests default colors and opacities of the plugin's representations: every interval is visible in its own color,
an array with one value is visible, and Opacity makes the volume more transparent.
"""

import numpy
from paraview import simple

from plugin_images import (
    VIEW_SIZE, add_array, color_by, coordinates, fraction_shown, grid, image, plain_view, producer,
    snapshot)
from plugin_testing import interval_volume, open_file, run

SIDE = 13
INTERVALS = 4
# Index of the largest color channel of each of the first intervals, which are blue, orange, green
# and red.
LARGEST_CHANNEL = (2, 0, 1, 0)
# Allowed difference between the opacity of each interval and the opacity of the first.
DENSITY_TOLERANCE = 0.02
KINDS = (("Shadowed Slices", image), ("Interval Volume", grid))


def layers(number):
    """Returns a cube with the given number of layers along x, one per interval."""
    data = grid(SIDE)
    centers = numpy.array([data.GetCell(i).GetBounds()[:2] for i in range(data.GetNumberOfCells())]).mean(axis=1)
    ids = numpy.floor(centers / (SIDE - 1) * number).astype(numpy.int32)
    add_array(data, "IntervalId", ids, False)
    return data


def show(source, kind):
    """Shows the source from the front, with x to the right, over the full width of the image."""
    view = plain_view()
    display = simple.Show(source, view)
    display.SetRepresentationType(kind)
    simple.Render(view)  # sets the default camera
    center = (SIDE - 1) / 2
    view.CameraParallelProjection = True
    view.CameraParallelScale = center
    view.CameraPosition = [center, center, 10 * SIDE]
    view.CameraFocalPoint = [center, center, center]
    return view, display


def bands(view, number):
    """Returns the mean color of each of `number` columns of the image, without their borders."""
    shot = snapshot(view).reshape(VIEW_SIZE[1], VIEW_SIZE[0], 3)
    width = VIEW_SIZE[0] // number
    margin = width // 4
    return [shot[100:200, i * width + margin:(i + 1) * width - margin].mean(axis=(0, 1)) for i in range(number)]


def depth(display, value):
    """Returns the opacity of a value."""
    function = display.ScalarOpacityFunction.GetClientSideObject()
    return function.GetValue(value)


def check_ids(checks):
    source = producer(layers(INTERVALS))
    view, display = show(source, "Interval Volume")
    color_by(display, ["CELLS", "IntervalId"])
    colors = bands(view, INTERVALS)
    for i, color in enumerate(colors):
        checks.that(color.max() > 40, f"interval {i} is visible: {color}")
        checks.equal(int(numpy.argmax(color)), LARGEST_CHANNEL[i], f"interval {i}, largest channel of {color}")
        checks.close(depth(display, i), depth(display, 0), DENSITY_TOLERANCE, f"interval {i}, opacity")
        for j in range(i):
            checks.that(numpy.abs(color - colors[j]).max() > 30, f"intervals {i} and {j} differ")
    checks.equal(list(display.LookupTable.Annotations)[::2], [str(i) for i in range(INTERVALS)], "annotations of the legend")

    # Rescaling, as by the client's button, must not change the colors.
    display.RescaleTransferFunctionToDataRange(False, True)
    for i, color in enumerate(bands(view, INTERVALS)):
        checks.that(numpy.abs(color - colors[i]).max() < 2, f"interval {i} after rescaling: {color}")

    # Add more intervals.
    more = INTERVALS + 2
    source.GetClientSideObject().SetOutput(layers(more))
    source.SMProxy.MarkModified(source.SMProxy)
    source.UpdatePipeline()
    snapshot(view)
    found = bands(view, more)
    for i, color in enumerate(found):
        checks.that(color.max() > 40, f"interval {i} of {more} is visible: {color}")
        for j in range(i):
            checks.that(numpy.abs(color - found[j]).max() > 15, f"intervals {i} and {j} of {more} differ")

    # User settings must be preserved.
    display.LookupTable.RGBPoints = [0.0, 1.0, 0.0, 0.0, more - 1.0, 0.0, 0.0, 1.0]
    display.ScalarOpacityFunction.Points = [0.0, 1.0, 0.5, 0.0, more - 1.0, 1.0, 0.5, 0.0]
    display.Representation = "Surface"
    display.Representation = "Interval Volume"
    first, last = bands(view, more)[0], bands(view, more)[-1]
    checks.that(first[0] > 200 and first[2] < 5, f"red as set: {first}")
    checks.that(last[2] > 200 and last[0] < 5, f"blue as set: {last}")
    simple.Delete(view)


def check_filter(checks):
    """Tests that each interval of a filter's output is visible."""
    source = open_file("disk_out_ref.vtu")
    volume = interval_volume(source, "Temp", [(300.0, 400.0), (500.0, 600.0), (700.0, 850.0)])
    view = plain_view()
    display = simple.Show(volume, view)
    display.SetRepresentationType("Interval Volume")
    color_by(display, ["CELLS", "IntervalId"])
    simple.ResetCamera(view)
    fractions = []
    for number in range(3):
        single = simple.Threshold(Input=volume, Scalars=["CELLS", "IntervalId"], ThresholdMethod="Between",
                                 LowerThreshold=number, UpperThreshold=number)
        simple.Hide(volume, view)
        single_display = simple.Show(single, view)
        single_display.SetRepresentationType("Interval Volume")
        color_by(single_display, ["CELLS", "IntervalId"])
        fractions.append(fraction_shown(snapshot(view)))
        simple.Hide(single, view)
    print("visible fractions of single intervals:", fractions)
    checks.that(min(fractions) > 0.05, f"each interval is visible: {fractions}")
    simple.Delete(view)


def check_constant(checks):
    """Tests arrays with a single value."""
    for kind, make in KINDS:
        for value in (0.0, 5.0, -3.0, 1e6):
            data = make(SIDE)
            name = f"constant {value}"  # functions are shared by name
            add_array(data, name, numpy.full(data.GetNumberOfPoints(), value))
            view, display = show(producer(data), kind)
            fraction = fraction_shown(snapshot(view))
            checks.that(fraction > 0.9, f"{kind}, constant {value}: {fraction} of the image")
            checks.equal(display.ColorArrayName.GetArrayName(), name, f"{kind}, constant, array")
            simple.Delete(view)


def check_opacity(checks):
    """Tests that Opacity makes the volume more transparent, with an array and without, and has no effect at
    1."""
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
                        f"{kind}, by {array}, Opacity reduces the brightness: {brightness}")
            checks.equal(brightness[3], 0.0, f"{kind}, by {array}, Opacity 0")
            display.Opacity = 1.0
            checks.equal(snapshot(view).mean(), brightness[0], f"{kind}, by {array}, Opacity restored to 1")
        simple.Delete(view)


def main(checks):
    check_ids(checks)
    check_filter(checks)
    check_constant(checks)
    check_opacity(checks)


run(main)
