# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the Inflow Textures representation reproduces images of the C++ mapper: textures from files, pulses
that move with the phase, opacity and shading by an array, cropping and shadows. With default settings, flow
fields must be visible, and an image without arrays must cause an error.

Argument: the directory for images.
"""

import sys

import numpy
from paraview import simple

from flow_testing import analytic_flow, flow_field
from plugin_images import (
    Comparison, fraction_shown, image, load_texture, look_at, make_view, image_path, plain_view,
    producer, set_light, snapshot)
from plugin_testing import extractions_path, open_file, read_extractions, run

REPRESENTATION = "Inflow Textures"
# Largest and mean difference between the images of ParaView and of the VTK modules, in steps of
# 1/255. Both show the same data, but the versions of VTK may differ.
BOUNDS = (2, 0.2)
TEXTURES = {"inflow": "InflowTexture", "surface": "InflowSurfaceTexture", "detail": "InflowDetailTexture"}
SURFACE_ID = 3


def make_field(picture):
    field = flow_field(analytic_flow(picture), picture)
    field.UpdatePipeline()
    return field


def draw(picture, path):
    field = make_field(picture)
    view = make_view(picture)
    display = simple.Show(field, view)
    display.SetRepresentationType(REPRESENTATION)
    display.InflowOpacityUnitDistance = picture["unit"]
    display.InflowPattern = "None"
    display.InflowSurfaceId = SURFACE_ID
    for key, name in TEXTURES.items():
        if picture[key]:
            setattr(display, name, load_texture(extractions_path(picture[key])))
    display.InflowPulseLength = picture["pulse"]
    display.InflowTimePhase = picture["phase"]
    if picture["opacity_range"]:
        display.InflowUseOpacityArray = True
        display.InflowOpacityArray = ["POINTS", "AdvectionTime"]
        display.InflowOpacityRange = picture["opacity_range"]
    if picture["shading"]:
        display.InflowShade = True
        display.InflowShadingArray = ["POINTS", picture["shading"]]
    display.InflowShadows = picture["shadows"]
    display.InflowUseCropping = picture["crop"] != [1.0, 1.0, 1.0]
    display.InflowCroppingScale = picture["crop"]
    display.Ambient = picture["ambient"]
    display.Diffuse = picture["diffuse"]
    view.UseLight = False
    set_light(simple.AddLight(view=view), picture["light"])
    simple.SaveScreenshot(path, view, ImageResolution=picture["size"])
    simple.Delete(view)  # before its window loses its display
    simple.Delete(field)


def check_defaults(checks, picture):
    """Tests that the field is visible with default settings and that all properties have documentation."""
    field = make_field(picture)
    view = plain_view()
    display = simple.Show(field, view)
    checks.that(REPRESENTATION in display.GetProperty("Representation").Available, "the representation is available")
    display.SetRepresentationType(REPRESENTATION)
    look_at(view)
    fraction = fraction_shown(snapshot(view))
    checks.that(fraction > 0.1, f"the field is visible with default settings: {fraction}")
    check_pattern(checks, view, display)
    for name in display.ListProperties():
        if name.startswith("Inflow"):
            text = display.GetProperty(name).SMProperty.GetDocumentation()
            checks.that(text and text.GetDescription().strip(), f"{name} has documentation")
    checks.that(display.GetProperty("InflowTimePhase").SMProperty.GetAnimateable(), "the phase can be animated")
    simple.Hide(field, view)
    checks.equal(fraction_shown(snapshot(view)), 0.0, "visible fraction of a hidden field")
    simple.Delete(view)
    simple.Delete(field)


def check_pattern(checks, view, display):
    """Tests that the first image shows a pattern of colors, which the property turns off, and that the panel
    tells how to load an image."""
    checks.equal(display.InflowPattern, "Checkerboard", "default pattern")

    def saturation():
        shot = snapshot(view)
        return numpy.mean(numpy.ptp(shot, axis=1) > 40)

    checks.that(saturation() > 0.05, f"colored fraction: {saturation()}")
    display.InflowPattern = "None"
    checks.equal(saturation(), 0.0, "colored fraction without a pattern")
    display.InflowPattern = "Checkerboard"
    text = display.GetProperty("InflowHelp").GetData()
    checks.that("Load" in text and "Inflow Texture" in text, f"help: {text}")


def check_file(checks):
    """Tests the flow of a file with default settings, except that the samples must be an image."""
    field = simple.ImplicitFlowField(Input=open_file("disk_out_ref.vtu"), SampleMode="Image")
    view = plain_view()
    simple.Show(field, view).SetRepresentationType(REPRESENTATION)
    look_at(view)
    fraction = fraction_shown(snapshot(view))
    checks.that(fraction > 0.1, f"disk_out_ref.vtu is visible: {fraction}")
    simple.Delete(view)
    simple.Delete(field)


def check_errors(checks):
    """Tests that the representation reports an image without arrays, for which the mapper is not called."""
    view = plain_view()
    display = simple.Show(producer(image()), view)
    display.SetRepresentationType(REPRESENTATION)
    messages = []
    active = display.GetClientSideObject().GetActiveRepresentation()
    active.AddObserver("ErrorEvent", lambda _, event: messages.append(event))
    checks.equal(fraction_shown(snapshot(view)), 0.0, "visible fraction without arrays")
    checks.equal(len(messages), 1, "errors without arrays")
    simple.Delete(view)


def main(checks):
    pictures = read_extractions("inflow_textures.json")
    check_defaults(checks, pictures[0])
    check_file(checks)
    check_errors(checks)
    comparison = Comparison(checks)
    for picture in pictures:
        path = image_path(sys.argv[1], "TestPluginInflowTextures", picture["name"])
        draw(picture, path)
        comparison.compare(picture["name"], path, BOUNDS)


run(main)
