# SPDX-License-Identifier: BSD-3-Clause
"""The representation Interval Volume draws what the mapper draws in C++, pixel by pixel.

Arguments: the folder for the pictures, and `whole`, or `distributed` in a run with several processes:
each has a piece of the data, and those pictures are compared that ordered compositing can make. Where
they cannot send each other grids, one warning says so, and the pictures are as good.
"""

import sys

from paraview import servermanager, simple

from flow_testing import analytic_flow, flow_field, flow_volume, inflow_mapping
from plugin_pictures import Comparison, make_view, picture_path, set_colors
from plugin_testing import (
    can_exchange_data, interval_volume, open_data, read_extractions, run, temporal_source,
    time_varying_volume, warnings_of)

REPRESENTATION = "Interval Volume"
# Largest and mean difference in steps of 1/255. Both round the same numbers, in other versions of VTK.
WHOLE_BOUNDS = (1, 0.2)
# Of many thin tetrahedra that overlap, one may begin or end at the very centre of a pixel.
IN_TIME_BOUNDS = (2, 0.1)
# One pixel's centre lies on a face that is seen edge-on, to the last digits of the camera.
ON_EDGE_BOUNDS = (2, 0.2)
# Cells that straddle the regions of two processes are drawn by one of them.
DISTRIBUTED_BOUNDS = (24, 0.4)
DISTRIBUTED_PICTURES = ("by-temperature", "by-interval")


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
    with warnings_of(display.GetClientSideObject().GetActiveRepresentation()) as said:
        set_colors(display, view, picture["color_by"], picture)
        show_as_in(picture, display)
        simple.SaveScreenshot(path, view, ImageResolution=picture["size"])
    simple.Delete(view)  # while its window still has a display
    simple.Delete(volume)
    return said


def show_as_in(picture, display):
    display.IntervalOpacityUnitDistance = picture["unit"]
    display.IntervalBlendMode = picture["blend"]
    display.IntervalSortMode = picture["sort"]
    display.IntervalIntegrationMode = picture["integration"]
    display.IntervalRenderPath = picture["path"]
    display.IntervalDeltaTArrayName = picture["delta_t"]
    display.IntervalLayerPriorities = [str(number) for row in picture["priorities"] for number in row]


def check_mapper(checks, display):
    """What no picture shows reaches the mapper too."""
    display.IntervalRenderPath = "OpenGL"
    display.IntervalAutoAdjustLevelOfDetail = False
    display.IntervalLayerArrayName = "TimeSlab"
    text = str(display.GetClientSideObject().GetActiveRepresentation())
    for line in ("RenderPath: 0", "AutoAdjustLevelOfDetail: 0", "LayerArrayName: TimeSlab"):
        checks.that(f" {line}\n" in text.split("Report:")[0], f"the mapper has {line}")


def check_choice(checks):
    """The representation can be chosen for the filter's output."""
    volume = interval_volume(open_data("wavelet"), "RTData", [(140.0, 180.0)])
    view = simple.CreateView("RenderView")
    display = simple.Show(volume, view)
    checks.that(REPRESENTATION in display.GetProperty("Representation").Available, "it can be chosen")
    display.SetRepresentationType(REPRESENTATION)
    simple.ColorBy(display, None)
    simple.Render(view)
    own = servermanager.ProxyManager().GetPrototypeProxy("representations", "IntervalVolumeRepresentation")
    for name in display.ListProperties():
        if name.startswith("Interval"):
            text = display.GetProperty(name).SMProperty.GetDocumentation()
            checks.that(text and text.GetDescription().strip(), f"{name} has a documentation")
    checks.that(own.GetDocumentation().GetDescription().strip(), "it has a documentation")
    check_mapper(checks, display)
    simple.Delete(view)


def bounds(picture, distributed):
    if distributed:
        return DISTRIBUTED_BOUNDS
    if picture["name"] == "extent-in-time":
        return ON_EDGE_BOUNDS
    return IN_TIME_BOUNDS if "source" in picture else WHOLE_BOUNDS


def main(checks):
    pictures = read_extractions("representation.json")
    distributed = sys.argv[2] == "distributed"
    said = []
    if distributed:
        pictures = [picture for picture in pictures if picture["name"] in DISTRIBUTED_PICTURES]
    else:
        check_choice(checks)
    comparison = Comparison(checks)
    for picture in pictures:
        name = picture["name"]
        path = picture_path(sys.argv[1], f"TestPluginRepresentation-{sys.argv[2]}", name)
        said += draw(picture, extract(picture, distributed), path)
        comparison.compare(name, path, bounds(picture, distributed))
    if distributed and not can_exchange_data():
        checks.said(said, "cannot send each other grids", "all pictures")
    else:
        checks.equal(said, [], "warnings")


run(main)
