# SPDX-License-Identifier: BSD-3-Clause
"""The representation Inflow Textures draws what the mapper draws in C++, with images from files,
pulses that move with the phase, opacity and shading by an array, cropping and shadows; at its
defaults a flow field is seen, of a formula as of a file; an image without arrays is an error.

Argument: the folder for the pictures.
"""

import sys

from paraview import simple

from flow_testing import analytic_flow, flow_field
from plugin_pictures import (
    Comparison, image, load_texture, look_at, make_view, picture_path, plain_view, producer, set_light, share_shown, snapshot)
from plugin_testing import extractions_path, open_file, read_extractions, run

REPRESENTATION = "Inflow Textures"
# Largest and mean difference in steps of 1/255. Both round the same numbers, in other versions of VTK.
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
    simple.Delete(view)  # while its window still has a display
    simple.Delete(field)


def check_defaults(checks, picture):
    """The field is seen as soon as the representation is chosen, and what is offered is explained."""
    field = make_field(picture)
    view = plain_view()
    display = simple.Show(field, view)
    checks.that(REPRESENTATION in display.GetProperty("Representation").Available, "it can be chosen")
    display.SetRepresentationType(REPRESENTATION)
    look_at(view)
    share = share_shown(snapshot(view))
    checks.that(share > 0.1, f"something is seen at the defaults: {share}")
    for name in display.ListProperties():
        if name.startswith("Inflow"):
            text = display.GetProperty(name).SMProperty.GetDocumentation()
            checks.that(text and text.GetDescription().strip(), f"{name} has a documentation")
    checks.that(display.GetProperty("InflowTimePhase").SMProperty.GetAnimateable(), "the phase can be animated")
    simple.Hide(field, view)
    checks.equal(share_shown(snapshot(view)), 0.0, "nothing of it is seen when it is hidden")
    simple.Delete(view)
    simple.Delete(field)


def check_file(checks):
    """A file's flow, with nothing set but that samples be an image."""
    field = simple.ImplicitFlowField(Input=open_file("disk_out_ref.vtu"), SampleMode="Image")
    view = plain_view()
    simple.Show(field, view).SetRepresentationType(REPRESENTATION)
    look_at(view)
    share = share_shown(snapshot(view))
    checks.that(share > 0.1, f"something is seen of disk_out_ref.vtu: {share}")
    simple.Delete(view)
    simple.Delete(field)


def check_errors(checks):
    """An image without arrays, of which the mapper is not asked: the representation says so."""
    view = plain_view()
    display = simple.Show(producer(image()), view)
    display.SetRepresentationType(REPRESENTATION)
    said = []
    active = display.GetClientSideObject().GetActiveRepresentation()
    active.AddObserver("ErrorEvent", lambda _, event: said.append(event))
    checks.equal(share_shown(snapshot(view)), 0.0, "nothing is seen without arrays")
    checks.equal(len(said), 1, "errors without arrays")
    simple.Delete(view)


def main(checks):
    pictures = read_extractions("inflow_textures.json")
    check_defaults(checks, pictures[0])
    check_file(checks)
    check_errors(checks)
    comparison = Comparison(checks)
    for picture in pictures:
        path = picture_path(sys.argv[1], "TestPluginInflowTextures", picture["name"])
        draw(picture, path)
        comparison.compare(picture["name"], path, BOUNDS)


run(main)
