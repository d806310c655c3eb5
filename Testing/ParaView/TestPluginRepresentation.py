# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the Interval Volume representation reproduces images of the C++ mapper.

Arguments: the directory for images, and `whole`, or `distributed` in a run with several processes. Each process
then has a piece of the data, and only images that support ordered compositing are compared. If the processes
cannot send each other grids, there must be one warning, and the images must still be equal.
"""

import re
import sys

from paraview import servermanager, simple

from flow_testing import analytic_flow, flow_field, flow_volume, inflow_mapping
from plugin_images import Comparison, make_view, image_path, set_colors
from plugin_testing import (
    can_exchange_data, interval_volume, open_data, read_extractions, run, temporal_source,
    time_varying_volume, warnings_of)

REPRESENTATION = "Interval Volume"
# Largest and mean difference between the images of ParaView and of the VTK modules, in steps of
# 1/255. Both show the same data, but the versions of VTK may differ.
FULL_BOUNDS = (1, 0.2)
# One of many thin overlapping tetrahedra may begin or end exactly at the center of a pixel.
IN_TIME_BOUNDS = (2, 0.1)
# The center of one pixel is on a face seen edge-on, up to rounding errors of the camera.
ON_EDGE_BOUNDS = (2, 0.2)
# Cells that straddle the regions of two processes are rendered by one of them.
DISTRIBUTED_BOUNDS = (24, 0.4)
DISTRIBUTED_IMAGES = ("by-temperature", "by-interval")


def extract(picture, distributed):
    if "volume" in picture:
        field = flow_field(analytic_flow(picture), picture)
        return flow_volume(inflow_mapping(field, picture), picture)
    if "source" in picture:
        source = temporal_source(picture["source"], picture["source_properties"])
        return time_varying_volume(source, picture["properties"])
    data = picture["data"]
    source = open_data(f"{data}_pieces.pvtu" if distributed else data)
    return interval_volume(source, picture["array"], picture["intervals"])


def draw(picture, volume, path):
    view = make_view(picture)
    display = simple.Show(volume, view)
    display.SetRepresentationType(REPRESENTATION)
    with warnings_of(display.GetClientSideObject().GetActiveRepresentation()) as messages:
        set_colors(display, view, picture["color_by"], picture)
        apply_settings(picture, display)
        simple.SaveScreenshot(path, view, ImageResolution=picture["size"])
    simple.Delete(view)  # before its window loses its display
    simple.Delete(volume)
    return messages


def apply_settings(picture, display):
    display.IntervalOpacityUnitDistance = picture["unit"]
    display.IntervalBlendMode = picture["blend"]
    display.IntervalSortMode = picture["sort"]
    display.IntervalIntegrationMode = picture["integration"]
    display.IntervalRenderPath = picture["path"]
    display.IntervalDeltaTArrayName = picture["delta_t"]
    display.IntervalLayerPriorities = [str(number) for row in picture["priorities"] for number in row]


def check_mapper(checks, display):
    """Tests settings of the mapper that do not affect the images."""
    display.IntervalRenderPath = "OpenGL"
    display.IntervalAutoAdjustLevelOfDetail = False
    display.IntervalLayerArrayName = "TimeSlab"
    text = str(display.GetClientSideObject().GetActiveRepresentation())
    for line in ("RenderPath: 0", "AutoAdjustLevelOfDetail: 0", "LayerArrayName: TimeSlab"):
        checks.that(f" {line}\n" in text.split("Report:")[0], f"the mapper has {line}")


def check_choice(checks):
    """Tests that the representation is available for the filter's output."""
    volume = interval_volume(open_data("wavelet"), "RTData", [(140.0, 180.0)])
    view = simple.CreateView("RenderView")
    display = simple.Show(volume, view)
    checks.that(REPRESENTATION in display.GetProperty("Representation").Available, "the representation is available")
    display.SetRepresentationType(REPRESENTATION)
    simple.ColorBy(display, None)
    simple.Render(view)
    own = servermanager.ProxyManager().GetPrototypeProxy("representations", "IntervalVolumeRepresentation")
    for name in display.ListProperties():
        if name.startswith("Interval"):
            text = display.GetProperty(name).SMProperty.GetDocumentation()
            checks.that(text and text.GetDescription().strip(), f"{name} has documentation")
    checks.that(own.GetDocumentation().GetDescription().strip(), "the representation has documentation")
    check_mapper(checks, display)
    simple.Delete(view)


def uploaded_bytes(display):
    """Returns the size of the last image that the mapper uploaded, or 0 if it showed an earlier image again."""
    text = str(display.GetClientSideObject().GetActiveRepresentation())
    return int(re.search(r"UploadedImageBytes: (\d+)", text.split("Report:")[1]).group(1))


def check_interaction(checks):
    """Tests that the mapper, not a surface of the tetrahedra, is rendered during interaction."""
    volume = interval_volume(open_data("wavelet"), "RTData", [(140.0, 180.0)])
    view = simple.CreateView("RenderView")
    view.LODThreshold = 0.0  # use the reduced level of detail for data of any size
    display = simple.Show(volume, view)
    display.SetRepresentationType(REPRESENTATION)
    display.IntervalRenderPath = "Software"
    for adjusts in (True, False):
        display.IntervalAutoAdjustLevelOfDetail = adjusts
        simple.Render(view)
        simple.Render(view)
        checks.equal(uploaded_bytes(display), 0, "bytes of an image that is shown again")
        view.CameraPosition = [1.1 * x for x in view.CameraPosition]
        view.SMProxy.InteractiveRender()
        checks.that((uploaded_bytes(display) > 0) == adjusts, f"level of detail {adjusts}: drawn by the mapper")
    simple.Delete(view)


def bounds(picture, distributed):
    if distributed:
        return DISTRIBUTED_BOUNDS
    if picture["name"] == "extent-in-time":
        return ON_EDGE_BOUNDS
    return IN_TIME_BOUNDS if "source" in picture else FULL_BOUNDS


def main(checks):
    pictures = read_extractions("representation.json")
    distributed = sys.argv[2] == "distributed"
    messages = []
    if distributed:
        pictures = [picture for picture in pictures if picture["name"] in DISTRIBUTED_IMAGES]
    else:
        check_choice(checks)
        check_interaction(checks)
    comparison = Comparison(checks)
    for picture in pictures:
        name = picture["name"]
        path = image_path(sys.argv[1], f"TestPluginRepresentation-{sys.argv[2]}", name)
        messages += draw(picture, extract(picture, distributed), path)
        comparison.compare(name, path, bounds(picture, distributed))
    if distributed and not can_exchange_data():
        checks.one_message(messages, "cannot send each other grids", "all images")
    else:
        checks.equal(messages, [], "warnings")


run(main)
