# SPDX-License-Identifier: BSD-3-Clause
"""The representation Shadowed Slices draws what the mapper draws in C++, with the view's lights and its
own, which come and go with it.

Arguments: the folder for the pictures, and `whole`, or `distributed` in a run with several processes,
where each has a piece of the image.
"""

import sys

from paraview import servermanager, simple

from plugin_pictures import Comparison, load_texture, make_view, picture_path, set_colors, set_light
from plugin_testing import extractions_path, open_data, read_extractions, run, temporal_source

REPRESENTATION = "Shadowed Slices"
# Largest and mean difference in steps of 1/255. Both round the same numbers, in other versions of VTK.
WHOLE_BOUNDS = (2, 0.2)
# Each process has slices of its own, which differ most where they meet the sides of the image edge on.
DISTRIBUTED_BOUNDS = (100, 0.4)
DISTRIBUTED_PICTURE = "slices-plain"
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
    simple.Delete(view)  # while its window still has a display
    simple.Delete(source)


def own_switches(view):
    """Of the projective lights that the view has: whether they are switched on."""
    lights = view.GetClientSideObject().GetRenderer().GetLights()
    lights = [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]
    return [light.GetSwitch() for light in lights if light.IsA("vtkProjectiveLight")]


def check_light(checks, view, source, display):
    """The own light shines with the representation, and only then."""
    simple.Render(view)
    checks.equal(own_switches(view), [0], "own light, off at first")
    display.ProjectiveLight = True
    simple.Render(view)
    checks.equal(own_switches(view), [1], "own light, switched on")
    display.SetRepresentationType("Outline")
    simple.Render(view)
    checks.equal(own_switches(view), [0], "own light, of a representation that is not shown")
    display.SetRepresentationType(REPRESENTATION)
    simple.Hide(source, view)
    checks.equal(own_switches(view), [0], "own light, hidden")
    simple.Show(source, view)
    checks.equal(own_switches(view), [1], "own light, shown again")
    simple.Delete(display)
    checks.equal(own_switches(view), [], "own light, of a representation that is gone")


def active_representation(display):
    return display.GetClientSideObject().GetActiveRepresentation()


def shown_input(display):
    """The image that the mapper draws."""
    return active_representation(display).GetActor().GetMapper().GetInputDataObject(0, 0)


def check_inputs(checks):
    """One image in a group is drawn; of two in one place one is, with a warning."""
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
        checks.that(points > 0, f"something is drawn of {number} images")
        simple.Hide(group, view)
    simple.Delete(view)


def check_components(checks, view, source, display):
    """Of an array with components the one chosen is drawn, or the magnitude."""
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
    """What no picture shows reaches the mapper too."""
    display.LightBufferSize = 777
    display.LightLookup = "Nearest"
    display.ImageSampleDistance = 3.0
    text = str(active_representation(display))
    for line in ("LightBufferSize: 777", "LightLookup: 0", "ImageSampleDistance: 3"):
        checks.that(f" {line}\n" in text.split("Report:")[0], f"the mapper has {line}")


def check_documentation(checks, display):
    own = servermanager.ProxyManager().GetPrototypeProxy("representations", "ShadowedSliceRepresentation")
    checks.that(own.GetDocumentation().GetDescription().strip(), "it has a documentation")
    for name in display.ListProperties():
        if name.startswith(OWN_PREFIXES) and name != "ShadowedInput":
            text = display.GetProperty(name).SMProperty.GetDocumentation()
            checks.that(text and text.GetDescription().strip(), f"{name} has a documentation")


def check_panel(checks):
    """What the panel offers, without pictures."""
    source = simple.Gradient(Input=open_data("wavelet"))
    source.UpdatePipeline()
    view = simple.CreateView("RenderView")
    display = simple.Show(source, view)
    checks.that(REPRESENTATION in display.GetProperty("Representation").Available, "it can be chosen")
    display.SetRepresentationType(REPRESENTATION)
    checks.equal(list(display.ProjectiveLightPosition), [10.0, 10.0, 10.0], "the light is at a corner")
    checks.equal(list(display.ProjectiveLightFocalPoint), [0.0, 0.0, 0.0], "the light shines at the centre")
    checks.equal(display.ProjectiveLightScreenWidth, 36.0, "the light's screen is larger than the data")
    checks.equal(display.MaximumNumberOfShadows, 1, "one light of the kit casts shadows")
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
        pictures = [picture for picture in pictures if picture["name"] == DISTRIBUTED_PICTURE]
    else:
        check_panel(checks)
        check_inputs(checks)
    comparison = Comparison(checks)
    for picture in pictures:
        path = picture_path(sys.argv[1], f"TestPluginShadowedSlices-{sys.argv[2]}", picture["name"])
        draw(picture, path)
        comparison.compare(picture["name"], path, DISTRIBUTED_BOUNDS if distributed else WHOLE_BOUNDS)


run(main)
