# SPDX-License-Identifier: BSD-3-Clause
"""Tests the area light of Shadowed Slices: widths of its soft shadows on a floor against geometry, switching it
with its representation, its image, and its handles.

Argument: a directory for images.
"""

import math
import os
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from plugin_images import (
    add_array, coordinates, fraction_shown, image, load_texture, look_at, plain_view, producer, snapshot)
from plugin_testing import open_file, run
from shadow_scene import add_sun, brightness, dark_view, make_plate, show_surface

WHITE = 255.0
SPACING = 0.25
ORIGIN = (-2.5, -2.0, 0.0)
CELLS = (28, 16, 16)
EDGE = 2.0  # the medium ends half a voxel outside
BOTTOM, TOP = 3.0, 4.0  # heights of the medium
TRANSMITTANCE = 0.05  # one unit of the medium
DISTANCE = 10.0  # from the light to its focal point


def make_slab():
    """Returns a volume above the floor that is empty except for its upper left part."""
    data = image(2, ORIGIN)
    data.SetDimensions(*(cells + 1 for cells in CELLS))
    data.SetSpacing(SPACING, SPACING, SPACING)
    x, _, z = coordinates(data).T
    add_array(data, "matter", ((x <= EDGE) & (z >= BOTTOM)).astype(float))
    return producer(data)


def show_slab(slab, view):
    display = simple.Show(slab, view)
    display.SetRepresentationType("Shadowed Slices")
    simple.ColorBy(display, ["POINTS", "matter"])
    display.LookupTable.RGBPoints = [0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
    display.ScalarOpacityFunction.Points = [0.0, 0.0, 0.5, 0.0, 1.0, 1.0 - TRANSMITTANCE, 0.5, 0.0]
    display.ShadowedOpacityUnitDistance = 1.0
    display.AutoAdjustSampleDistances = False
    return display


def make_scene():
    """Returns a view with a floor, dense smoke above it, and the area light of the display above both."""
    view = dark_view()
    slab = make_slab()
    show_surface(make_plate((-8.0, -8.0), 16.0, 0.0), view)
    display = show_slab(slab, view)
    display.SceneShadows = True
    display.AreaLight = True
    display.AreaLightPosition = [0.0, 0.0, DISTANCE]
    display.AreaLightFocalPoint = [0.0, 0.0, 0.0]
    display.AreaLightWidth = display.AreaLightHeight = 0.0
    display.LightBufferSize = 128
    return view, slab, display


def profile(view, shot):
    """Returns the light along x in front of the slab, across the right edge of its shadow."""
    return numpy.array([brightness(view, shot, (x, -1.5, 0.0)) for x in numpy.arange(0.5, 4.0, 0.05)]) / WHITE


def width_of(values):
    """Returns the width of a linear ramp of equal spread: the square root of 12 times the variance of the
    rise."""
    rise = numpy.diff(values)
    positions = numpy.arange(len(rise)) * 0.05
    mean = (rise * positions).sum() / rise.sum()
    return float(numpy.sqrt(max(0.0, 12.0 * (rise * (positions - mean) ** 2).sum() / rise.sum())))


def check_width(checks, view, display):
    """A parallel square light of width w, with the size seen from the focal point at distance D, has a
    penumbra of width w z / D behind an edge at height z. The edges of the slab are at heights z from 3 to
    4."""
    values = profile(view, snapshot(view))
    checks.that(abs(values[0] - TRANSMITTANCE) < 0.02 and values[-1] > 0.98, f"shadow of size 0: {values}")
    checks.that(width_of(values) < 0.35, f"width of a hard shadow: {width_of(values)}")
    display.AreaLightShape = "Square"
    for size in (2.0, 4.0):
        display.AreaLightWidth = size
        soft = profile(view, snapshot(view))
        minimum, maximum = (size * z / DISTANCE for z in (BOTTOM, TOP))
        found = width_of(soft)
        checks.that(0.9 * minimum < found < 1.1 * maximum, f"width of {size}: {found}, expected {minimum} to {maximum}")
        checks.that(numpy.diff(soft).min() > -0.02, f"shadow of {size} increases monotonically: {soft}")
    across = abs(width_of(profile(view, snapshot(view))))
    display.AreaLightWidth, display.AreaLightHeight = 0.0, 4.0
    along = width_of(profile(view, snapshot(view)))
    checks.that(along < across / 2, f"edge along the light's height: {along}")
    display.AreaLightViewUp = [1.0, 0.0, 0.0]
    rotated = width_of(profile(view, snapshot(view)))
    checks.that(abs(rotated - across) < 0.1 * across, f"a rotated light: {rotated}, expected {across}")
    display.AreaLightViewUp = [0.0, 1.0, 0.0]
    display.AreaLightWidth = display.AreaLightHeight = 4.0


def check_settings(checks, view, display):
    """Tests that settings of the light change the image. Next to surfaces, the mapper uses at least 16
    samples."""
    soft = snapshot(view)
    for name, value in (("SoftShadowMethod", "Accumulated Convolution"), ("NumberOfLightSamples", 100),
                        ("AreaLightShape", "Round"), ("AreaLightPositional", "Lamp"),
                        ("AreaLightColor", [1.0, 0.5, 0.5]), ("AreaLightIntensity", 0.5),
                        ("AreaLightShadows", 0)):
        first = display.GetProperty(name).GetData()
        setattr(display, name, value)
        checks.that(numpy.abs(snapshot(view) - soft).max() > 4, f"{name} changes the image")
        setattr(display, name, first)
    checks.equal(numpy.abs(snapshot(view) - soft).max(), 0, "difference after restoring the values")


def check_image(checks, view, display, folder):
    """Tests an image with one bright half, which halves the light."""
    soft = profile(view, snapshot(view))
    values = numpy.zeros((8, 8, 3), numpy.uint8)
    values[:, 4:] = 255
    data = vtkImageData()
    data.SetDimensions(8, 8, 1)
    array = numpy_to_vtk(values.reshape(-1, 3), deep=True)
    data.GetPointData().SetScalars(array)
    path = os.path.join(folder, "TestPluginAreaLight.png")
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.Write()
    display.AreaLightImage = load_texture(path)
    half = profile(view, snapshot(view))
    ratio = width_of(half) / width_of(soft)
    checks.that(0.4 < ratio < 0.7, f"half the light has half the penumbra: {ratio}")
    display.AreaLightImage = None
    checks.close(width_of(profile(view, snapshot(view))), width_of(soft), 1e-6, "width after removing the image")


def own_lights(view):
    lights = view.GetClientSideObject().GetRenderer().GetLights()
    lights = [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]
    return [light.GetSwitch() for light in lights if light.IsA("vtkAreaLight")]


def check_light(checks, view, slab, display):
    """Tests that the light is on only while its representation is visible."""
    checks.equal(own_lights(view), [1], "switched on")
    simple.Hide(slab, view)
    checks.equal(own_lights(view), [0], "hidden")
    simple.Show(slab, view)
    display.SetRepresentationType("Outline")
    simple.Render(view)
    checks.equal(own_lights(view), [0], "an outline")
    display.SetRepresentationType("Shadowed Slices")
    display.AreaLight = False
    simple.Render(view)
    checks.equal(own_lights(view), [0], "switched off")
    simple.Delete(display)
    checks.equal(own_lights(view), [], "deleted")


def check_view_lights(checks, view, display):
    """Tests that ViewLightAngle turns a light of the view into an area light of that size, and that the view
    has its own lights between frames."""
    display.AreaLightShape = "Round"
    display.AreaLightWidth = display.AreaLightHeight = 2.0
    own = snapshot(view)
    display.AreaLight = False
    light = add_sun(view)
    hard = snapshot(view)
    checks.that(width_of(profile(view, hard)) < width_of(profile(view, own)) / 2, "the sun's shadow is hard")
    display.ViewLightAngle = 2.0 * math.degrees(math.atan(1.0 / DISTANCE))
    soft = snapshot(view)
    checks.that(numpy.abs(soft - own).max() <= 1,
                f"difference between widened sun and area light: {numpy.abs(soft - own).max()}")
    checks.equal(own_lights(view), [0], "area lights between frames")
    display.ViewLightAngle = 0.0
    checks.equal(numpy.abs(snapshot(view) - hard).max(), 0, "difference after restoring the sun's hard shadow")
    simple.RemoveLight(light)
    display.AreaLight = True


def check_defaults(checks):
    """Tests that the area light, switched on with default settings, is the main light of a scan and does not
    overexpose it, and that the view has its own lights between frames."""
    view = plain_view()
    display = simple.Show(open_file("tooth.vti"), view)
    display.SetRepresentationType("Shadowed Slices")
    look_at(view)
    before = snapshot(view)
    display.AreaLight = True
    lit = snapshot(view)
    display.AreaLightViewLights = 1.0
    added = snapshot(view)

    def overexposed(shot):
        return (shot.max(axis=1) >= 255).mean() / fraction_shown(shot)

    print(f"overexposed: {overexposed(before):.4f}, {overexposed(lit):.4f}, without dimming {overexposed(added):.4f}")
    checks.that(overexposed(lit) < 0.001, f"overexposed fraction: {overexposed(lit)}")
    checks.that(lit.mean() > 0.7 * before.mean(), f"brightness: {lit.mean()}, before {before.mean()}")
    checks.that(added.mean() > 1.1 * lit.mean(), "the other lights are dimmed")
    lights = view.GetClientSideObject().GetRenderer().GetLights()
    kinds = [lights.GetItemAsObject(i).GetClassName() for i in range(lights.GetNumberOfItems())]
    checks.equal(kinds.count("vtkAreaLight"), 1, f"area lights between frames, {kinds}")
    display.AreaLight = False
    checks.equal(numpy.abs(snapshot(view) - before).max(), 0, "difference after switching the light off")
    simple.Delete(view)


class Handles:
    """The handles of an area light in a view, dragged without a mouse."""

    def __init__(self, view, values):
        self.proxy = servermanager.ProxyManager().NewProxy("representations", "InterlumeAreaLightWidget")
        self.set(values)
        self.representation = self.proxy.GetClientSideObject().GetRepresentation()
        self.renderer = view.GetClientSideObject().GetRenderer()
        self.representation.SetRenderer(self.renderer)

    def set(self, values):
        for name, numbers in values.items():
            for i, number in enumerate(numbers):
                self.proxy.GetProperty(name).SetElement(i, number)
        self.proxy.UpdateVTKObjects()

    def get(self, name):
        self.proxy.UpdatePropertyInformation()
        values = self.proxy.GetProperty(name + "Info")
        return [values.GetElement(i) for i in range(values.GetNumberOfElements())]

    def display(self, point):
        self.renderer.SetWorldPoint(*point, 1.0)
        self.renderer.WorldToDisplay()
        return numpy.array(self.renderer.GetDisplayPoint())

    def world(self, pixel):
        self.renderer.SetDisplayPoint(*pixel)
        self.renderer.DisplayToWorld()
        point = numpy.array(self.renderer.GetWorldPoint())
        return point[:3] / point[3]

    def drag(self, point, motion):
        """Drags from the pixel of a point by a motion in pixels. Returns the interaction state and the motion
        in world coordinates."""
        pixel = self.display(point)
        state = self.representation.ComputeInteractionState(int(pixel[0]), int(pixel[1]))
        self.representation.StartWidgetInteraction(pixel[:2])
        after = pixel + [*motion, 0.0]
        self.representation.WidgetInteraction(after[:2])
        return state, self.world(after) - self.world(pixel)


def check_handles(checks, view):
    """Tests that each handle is found under the cursor and changes only its own value."""
    first = {"WorldPosition": [0.0, 0.0, 3.0], "FocalPoint": [0.0, 0.0, 0.0], "Width": [2.0], "Height": [8.0]}
    handles = Handles(view, first)
    cases = (("WorldPosition", (0.0, 0.0, 3.0), 1.0), ("FocalPoint", (0.0, 0.0, 0.0), 1.0),
             ("Width", (1.0, 0.0, 3.0), 2.0), ("Height", (0.0, 4.0, 3.0), 2.0))
    for name, point, factor in cases:
        handles.set(first)
        if factor == 2.0:  # the handle is some pixels outside the edge
            direction = numpy.array(point) * [1.0, 1.0, 0.0]
            step = direction / numpy.linalg.norm(direction) * 0.05
            point = next(candidate for candidate in (numpy.array(point) + i * step for i in range(1, 60))
                         if handles.representation.ComputeInteractionState(*(int(n) for n in handles.display(candidate)[:2])))
        state, moved = handles.drag(point, (12.0, 9.0))
        checks.that(state > 0, f"there is a handle for {name}")
        for other, values in first.items():
            found = numpy.array(handles.get(other)) - values
            expected = numpy.zeros(len(values))
            if other == name:
                axis = {"Width": 0, "Height": 1}.get(name)
                expected = moved if axis is None else factor * moved[axis:axis + 1]
                checks.that(numpy.abs(expected).max() > 0.1, f"dragging changes {name}")
            # The depth of the cursor may differ from the depth of the handle's center.
            bound = 0.05 * numpy.abs(expected).max() + 1e-9
            checks.that(numpy.abs(found - expected).max() < bound,
                        f"{other} after dragging {name}: {found}, {expected}")
    handles.set(first)
    checks.equal(handles.representation.ComputeInteractionState(5, 5), 0, "interaction state in a corner of the view")
    count = next(x for x in range(1, 60) if handles.representation.ComputeInteractionState(
        *(int(n) for n in handles.display((1.0 + 0.05 * x, 0.0, 3.0))[:2])))
    handles.drag((1.0 + 0.05 * count, 0.0, 3.0), (-200.0, 0.0))
    checks.equal(handles.get("Width"), [0.0], "the width is not negative")


def check_no_bounds():
    """Tests that data without bounds, for which ParaView proposes a negative size of the light, cause no error."""
    view = plain_view()
    display = simple.Show(producer(vtkImageData()), view)
    display.SetRepresentationType("Shadowed Slices")
    display.AreaLight = True
    snapshot(view)
    simple.Delete(view)


def main(checks):
    check_no_bounds()
    check_defaults(checks)
    view, slab, display = make_scene()
    check_width(checks, view, display)
    check_settings(checks, view, display)
    check_image(checks, view, display, sys.argv[1])
    check_handles(checks, view)
    check_view_lights(checks, view, display)
    check_light(checks, view, slab, display)


run(main)
