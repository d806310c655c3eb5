# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the Shadowed Slices representation reproduces images of the C++ mapper, with lights of the view and
the representation's own light, which is on only while it is visible.

Arguments: the directory for images, and `whole`, or `distributed` in a run with several processes, in which each
has a piece of the image data.
"""

import sys

from paraview import servermanager, simple

from plugin_images import Comparison, load_texture, make_view, image_path, set_colors, set_light
from plugin_testing import extractions_path, open_data, read_extractions, run, temporal_source

REPRESENTATION = "Shadowed Slices"
# Largest and mean difference between the images of ParaView and of the VTK modules, in steps of
# 1/255. Both show the same data, but the versions of VTK may differ.
FULL_BOUNDS = (2, 0.2)
# Each process has its own slices. Slices differ most where they intersect the faces of the volume
# at grazing angles.
DISTRIBUTED_BOUNDS = (100, 0.4)
DISTRIBUTED_IMAGE = "slices-plain"
PROPERTIES = {
    "ambient": "Ambient", "unit": "ShadowedOpacityUnitDistance", "shade": "ShadowedShade",
    "shadows": "Shadows", "number_of_shadows": "MaximumNumberOfShadows", "colored": "ColoredShadows",
    "spacing": "SliceSpacing"}
OWN_PREFIXES = ("AreaLight", "Colored", "ImageSample", "Light", "MaximumNumberOfS", "MultipleScattering",
                "NumberOfLight", "Projective", "Scattering", "Scene", "Shadow", "SliceSpacing", "SoftShadow", "ViewLight")


def add_lights(view, display, picture):
    view.UseLight = picture["kit"]
    if "light" in picture:
        set_light(simple.AddLight(view=view), picture["light"])
    if "projector" in picture:
        set_projector(display, picture["projector"])


def set_projector(display, values):
    display.ProjectiveLight = True
    display.ProjectiveLightPositional = "Point"
    display.ProjectiveLightPosition = values["position"]
    display.ProjectiveLightFocalPoint = values["focus"]
    display.ProjectiveLightViewUp = values["up"]
    display.ProjectiveLightScreenWidth, display.ProjectiveLightScreenHeight = values["screen"]
    display.ProjectiveLightEdgeWidth = values["edge"]
    display.ProjectiveLightColor = values["color"]
    display.ProjectiveLightIntensity = values["intensity"]
    display.ProjectiveLightImage = load_texture(extractions_path(values["image"]))


def draw(picture, path):
    source = temporal_source(picture["source"], picture["source_properties"])
    view = make_view(picture)
    display = simple.Show(source, view)
    display.SetRepresentationType(REPRESENTATION)
    set_colors(display, view, ["POINTS", picture["array"]], picture)
    add_lights(view, display, picture)
    for key, name in PROPERTIES.items():
        setattr(display, name, picture[key])
    display.AutoAdjustSampleDistances = False
    if picture["crop"]:
        display.ShadowedUseCropping = True
        display.ShadowedCroppingScale = picture["crop"]
    simple.SaveScreenshot(path, view, ImageResolution=picture["size"])
    simple.Delete(view)  # before its window loses its display
    simple.Delete(source)


def own_lights(view):
    """Returns the projective lights in the view."""
    lights = view.GetClientSideObject().GetRenderer().GetLights()
    lights = [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]
    return [light for light in lights if light.IsA("vtkProjectiveLight")]


def own_switches(view):
    """Returns the switch of each projective light in the view."""
    return [light.GetSwitch() for light in own_lights(view)]


def check_light(checks, view, source, display):
    """Tests that the representation's light is on only while the representation is visible."""
    simple.Render(view)
    checks.equal(own_switches(view), [0], "own light, off by default")
    display.ProjectiveLight = True
    simple.Render(view)
    checks.equal(own_switches(view), [1], "own light, switched on")
    for interpolates, printed in ((0, "Off"), (1, "On")):
        display.ProjectiveLightInterpolate = interpolates
        simple.Render(view)
        checks.that(f"Interpolate: {printed}" in str(own_lights(view)[0]), "interpolation of the light's image")
    display.SetRepresentationType("Outline")
    simple.Render(view)
    checks.equal(own_switches(view), [0], "own light with an outline")
    display.SetRepresentationType(REPRESENTATION)
    simple.Hide(source, view)
    checks.equal(own_switches(view), [0], "own light, hidden")
    simple.Show(source, view)
    checks.equal(own_switches(view), [1], "own light, shown again")
    simple.Delete(display)
    checks.equal(own_switches(view), [], "own light of a deleted representation")


def active_representation(display):
    return display.GetClientSideObject().GetActiveRepresentation()


def shown_input(display):
    """Returns the image that the mapper renders."""
    return active_representation(display).GetActor().GetMapper().GetInputDataObject(0, 0)


def check_inputs(checks):
    """Tests that an image in a group is shown; of two images at the same position only one is shown, with a
    warning."""
    wavelet = open_data("wavelet")
    view = simple.CreateView("RenderView")
    for number, warnings in ((1, 0), (2, 1)):
        group = simple.GroupDatasets(Input=[wavelet] * number)
        group.UpdatePipeline()
        display = simple.Show(group, view)
        display.SetRepresentationType(REPRESENTATION)
        simple.ColorBy(display, ["POINTS", "RTData"])
        messages = []
        active_representation(display).AddObserver("WarningEvent", lambda _, event: messages.append(event))
        simple.Render(view)
        checks.equal(len(messages), warnings, f"warnings for {number} images")
        points = shown_input(display).GetNumberOfPoints()
        checks.that(points > 0, f"an image is rendered for {number} images")
        simple.Hide(group, view)
    simple.Delete(view)


def check_components(checks, view, source, display):
    """Tests that the selected component of an array, or the magnitude, is rendered."""
    simple.ColorBy(display, ["POINTS", "Gradient"])
    display.LookupTable.VectorMode = "Magnitude"
    simple.Render(view)
    vectors = servermanager.Fetch(source).GetPointData().GetArray("Gradient")
    for mode, component in (("Magnitude", -1), ("Component", 2)):
        display.LookupTable.VectorMode = mode
        display.LookupTable.VectorComponent = max(component, 0)
        simple.Render(view)
        drawn = shown_input(display).GetPointData().GetArray("Gradient")
        checks.equal(drawn.GetNumberOfComponents(), 1, f"{mode}, components")
        found, expected = drawn.GetRange(), vectors.GetRange(component)
        for value, bound in zip(found, expected):
            checks.close(value, bound, 1e-6, f"{mode}, range")


def check_mapper(checks, display):
    """Tests settings of the mapper that do not affect the images."""
    display.LightBufferSize = 777
    display.LightLookup = "Nearest"
    display.ImageSampleDistance = 3.0
    text = str(active_representation(display))
    for line in ("LightBufferSize: 777", "LightLookup: 0", "ImageSampleDistance: 3"):
        checks.that(f" {line}\n" in text.split("Report:")[0], f"the mapper has {line}")


def check_documentation(checks, display):
    own = servermanager.ProxyManager().GetPrototypeProxy("representations", "ShadowedSliceRepresentation")
    checks.that(own.GetDocumentation().GetDescription().strip(), "the representation has documentation")
    for name in display.ListProperties():
        if name.startswith(OWN_PREFIXES) and name != "ShadowedInput":
            text = display.GetProperty(name).SMProperty.GetDocumentation()
            checks.that(text and text.GetDescription().strip(), f"{name} has documentation")


def check_panel(checks):
    """Tests the panel's properties and defaults."""
    source = simple.Gradient(Input=open_data("wavelet"))
    source.UpdatePipeline()
    view = simple.CreateView("RenderView")
    display = simple.Show(source, view)
    checks.that(REPRESENTATION in display.GetProperty("Representation").Available, "the representation is available")
    display.SetRepresentationType(REPRESENTATION)
    checks.equal(list(display.ProjectiveLightPosition), [10.0, 10.0, 10.0], "default position of the light")
    checks.equal(list(display.ProjectiveLightFocalPoint), [0.0, 0.0, 0.0], "default focal point of the light")
    checks.equal(display.ProjectiveLightScreenWidth, 36.0, "default width of the light's screen")
    checks.equal(display.MaximumNumberOfShadows, 1, "default number of lights with shadows")
    simple.ColorBy(display, None)
    simple.Render(view)
    check_components(checks, view, source, display)
    check_mapper(checks, display)
    check_documentation(checks, display)
    check_light(checks, view, source, display)
    simple.Delete(view)


def main(checks):
    distributed = sys.argv[2] == "distributed"
    pictures = read_extractions("shadowed_slices.json")
    if distributed:
        pictures = [picture for picture in pictures if picture["name"] == DISTRIBUTED_IMAGE]
    else:
        check_panel(checks)
        check_inputs(checks)
    comparison = Comparison(checks)
    for picture in pictures:
        path = image_path(sys.argv[1], f"TestPluginShadowedSlices-{sys.argv[2]}", picture["name"])
        draw(picture, path)
        comparison.compare(picture["name"], path, DISTRIBUTED_BOUNDS if distributed else FULL_BOUNDS)


run(main)
