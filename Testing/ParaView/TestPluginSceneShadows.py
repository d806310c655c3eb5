# SPDX-License-Identifier: BSD-3-Clause
"""Scene Shadows of Shadowed Slices: surfaces and volumes of a view shadow each other, as much as closed
forms say, whatever the view is told, as long as the volume is visible; nothing of it is left after.

Argument: a folder for pictures and a state."""

import os
import sys

import numpy
from paraview import servermanager, simple

from plugin_pictures import pixels, snapshot
from plugin_testing import run
from shadow_scene import (
    BENEATH_PLATE, BENEATH_SMOKE, FLOOR, SLAB_TRANSMITTANCE, SMOKE, SMOKE_UNDER_PLATE, add_sun, brightness,
    dark_view, drawing_pass, make_sources, show_scene, show_slab)

WHITE = 255.0
ROUNDING = 2.0  # steps of 1/255
OWN_PASS = "vtkShadowedScenePass"
FIRST_PASS = "vtkPVDefaultPass"


def check_point(checks, view, shot, point, expected, what):
    found = brightness(view, shot, point)
    checks.that(abs(found - expected) <= ROUNDING, f"{what}: {found}, expected {expected}")


def check_values(checks, view, shot, what):
    """Light that plate and smoke leave on the floor, and in the smoke's front."""
    check_point(checks, view, shot, FLOOR, WHITE, f"{what}: floor in the light")
    check_point(checks, view, shot, BENEATH_SMOKE, WHITE * SLAB_TRANSMITTANCE, f"{what}: beneath the smoke")
    check_point(checks, view, shot, BENEATH_PLATE, 0.0, f"{what}: beneath the plate")
    dark, bright = (brightness(view, shot, point) for point in (SMOKE_UNDER_PLATE, SMOKE))
    checks.that(dark < 20 and bright > 80, f"{what}: smoke beneath the plate {dark}, beside it {bright}")


def check_hard(checks, view, displays):
    """Off: the view's own pass and picture, bit for bit after it was on. On: the shadows."""
    before = snapshot(view)
    first = drawing_pass(view)
    checks.equal(first.GetClassName(), FIRST_PASS, "pass at first")
    check_point(checks, view, before, BENEATH_SMOKE, WHITE, "without: beneath the smoke")
    displays["slab"].SceneShadows = True
    after = snapshot(view)
    check_values(checks, view, after, "scene shadows")
    checks.equal(drawing_pass(view).GetClassName(), OWN_PASS, "pass, on")
    check_point(checks, view, after, SMOKE, brightness(view, before, SMOKE), "smoke that no surface shadows")
    displays["slab"].SceneShadows = False
    checks.equal(numpy.abs(snapshot(view) - before).max(), 0, "picture, off again")
    checks.that(drawing_pass(view) is first, "the view's own pass, off again")
    displays["slab"].SceneShadows = True


def check_view(checks, view, displays, folder):
    """Camera, size, settings of the view that make its passes anew, and a screenshot."""
    view.CameraPosition = [3.0, -16.0, 8.0]
    check_values(checks, view, snapshot(view), "another camera")
    view.CameraPosition = [0.0, -16.0, 7.0]
    view.ViewSize = [420, 330]
    check_values(checks, view, snapshot(view), "another size")
    # Ambient occlusion of ParaView 6 wants every volume shaded.
    slab = displays["slab"]
    slab.ShadowedShade, shade = 1, slab.ShadowedShade
    for name in ("UseFXAA", "UseAmbientOcclusion", "DepthPeeling", "HiddenLineRemoval"):
        value = getattr(view, name)
        setattr(view, name, 1 - value)
        shot = snapshot(view)
        dark, bright = (brightness(view, shot, point) for point in (BENEATH_PLATE, FLOOR))
        checks.that(dark < 20 and bright > 200, f"{name} changed: floor {dark}, {bright}")
        setattr(view, name, value)
    slab.ShadowedShade = shade
    check_values(checks, view, snapshot(view), "after other settings of the view")
    path = os.path.join(folder, "TestPluginSceneShadows.png")
    size = list(view.ViewSize)
    simple.SaveScreenshot(path, view, ImageResolution=size)
    check_values(checks, view, pixels(path), "screenshot")
    simple.SaveScreenshot(path, view, ImageResolution=[2 * length for length in size])
    double = pixels(path).reshape(2 * size[1], 2 * size[0], 3)[::2, ::2].reshape(-1, 3)
    check_values(checks, view, double, "larger screenshot")


def selected_cells(view, source):
    width, height = view.ViewSize
    simple.ClearSelection(source)
    simple.SelectSurfaceCells(Rectangle=[0, 0, width - 1, height - 1], View=view)
    proxy = source.SMProxy.GetSelectionInput(0)
    return list(servermanager._getPyProxy(proxy).Input[0].IDs) if proxy else []


def check_selection(checks, view, sources, displays):
    simple.Render(view)
    found = selected_cells(view, sources["floor"])
    checks.that(found, "cells of the floor are selected")
    displays["slab"].SceneShadows = False
    simple.Render(view)
    checks.equal(selected_cells(view, sources["floor"]), found, "cells selected with and without")
    displays["slab"].SceneShadows = True
    for source in sources.values():
        simple.ClearSelection(source)


def check_visibility(checks, view, sources, displays):
    """The shadows go and come with the volume."""
    slab = displays["slab"]

    def check(name, what):
        simple.Render(view)
        checks.equal(drawing_pass(view).GetClassName(), name, what)

    simple.Hide(sources["slab"], view)
    check(FIRST_PASS, "pass, the volume hidden")
    check_point(checks, view, snapshot(view), BENEATH_PLATE, WHITE, "floor, the volume hidden")
    simple.Show(sources["slab"], view)
    check(OWN_PASS, "pass, shown again")
    slab.SetRepresentationType("Outline")
    check(FIRST_PASS, "pass, an outline")
    slab.SetRepresentationType("Shadowed Slices")
    check(OWN_PASS, "pass, Shadowed Slices again")
    slab.Shadows = False
    shot = snapshot(view)
    check_point(checks, view, shot, BENEATH_SMOKE, WHITE, "volume without Shadows casts none")
    slab.Shadows = True
    slab.MaximumNumberOfShadows = 0
    check_point(checks, view, snapshot(view), BENEATH_PLATE, WHITE, "no light casts shadows")
    slab.MaximumNumberOfShadows = 1


def check_several(checks, view, sources):
    """A second view has its own setting. Of two volumes that want shadows the larger values count."""
    other = dark_view()
    add_sun(other)
    displays = show_scene(sources, other)
    shot = snapshot(other)
    check_point(checks, other, shot, BENEATH_PLATE, WHITE, "another view has no shadows")
    check_values(checks, view, snapshot(view), "first view, beside another")
    displays["slab"].SceneShadows = True
    check_values(checks, other, snapshot(other), "another view")
    second = simple.Wavelet(WholeExtent=[4, 5, 4, 5, 4, 5])
    volume = show_slab(second, other)
    volume.SceneShadows = True
    volume.SceneDepthMapResolution = 2000
    displays["slab"].SceneDepthBias = 3.0
    simple.Render(other)
    text = str(drawing_pass(other))
    for line in ("DepthMapResolution: 2000", "DepthBias: 3", "Volumes: 2", "ShadowCasters: 2"):
        checks.that(f" {line}\n" in text, f"two volumes: {line}")
    simple.Delete(displays["slab"])
    simple.Render(other)
    checks.equal(drawing_pass(other).GetClassName(), OWN_PASS, "one of two volumes is left")
    simple.Delete(volume)
    simple.Render(other)
    checks.equal(drawing_pass(other).GetClassName(), FIRST_PASS, "no volume is left")
    simple.Delete(other)
    check_values(checks, view, snapshot(view), "first view, the other deleted")


def check_state(checks, displays, folder):
    """A state keeps all of it."""
    slab = displays["slab"]
    slab.AreaLight = True
    values = {"SceneDepthMapResolution": 512, "SceneDepthBias": 2.0, "AreaLightShape": "Square",
              "AreaLightPositional": "Lamp", "AreaLightPosition": [1.0, 2.0, 9.0], "AreaLightWidth": 0.5,
              "AreaLightHeight": 0.75, "AreaLightViewUp": [1.0, 0.0, 0.0], "AreaLightIntensity": 0.0,
              "SoftShadowMethod": "Sampled Lights", "NumberOfLightSamples": 9}
    for name, value in values.items():
        setattr(slab, name, value)
    path = os.path.join(folder, "TestPluginSceneShadows.pvsm")
    simple.SaveState(path)
    simple.ResetSession()
    simple.LoadState(path)
    view = simple.GetActiveViewOrCreate("RenderView")
    slab = next(display for display in view.Representations
                if "SceneShadows" in display.ListProperties() and display.Representation == "Shadowed Slices")
    checks.equal(slab.SceneShadows, 1, "scene shadows of a state")
    for name, value in values.items():
        found = getattr(slab, name)
        checks.equal(list(found) if isinstance(value, list) else found, value, f"{name} of a state")
    check_values(checks, view, snapshot(view), "state")


def begin():
    """The view with its light, the sources and how they are shown."""
    view = dark_view()
    add_sun(view)
    sources = make_sources()
    return view, sources, show_scene(sources, view)


def main(checks):
    view, sources, displays = begin()
    check_hard(checks, view, displays)
    check_view(checks, view, displays, sys.argv[1])
    check_visibility(checks, view, sources, displays)
    check_several(checks, view, sources)
    check_state(checks, displays, sys.argv[1])
    simple.ResetSession()
    # A selection, cleared or not, is an error in a state of ParaView 6.
    check_selection(checks, *begin())


run(main)
