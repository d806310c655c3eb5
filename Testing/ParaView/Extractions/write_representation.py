# SPDX-License-Identifier: BSD-3-Clause
"""write_representation.py FOLDER: writes images for the plugin test of the Interval Volume representation.

Writes representation.json, a list of cases with data or source, extraction, settings and camera, and an
image `<name>.png` for each. ParaView must reproduce the images.
"""

import sys

from interlume import (
    vtkAnalyticFieldSource, vtkAnalyticFlowSource, vtkTimeWeightedTetrahedraMapper)

import pipelines
from images import gyroid_camera, make_renderer, make_volume, write_images
from pipelines import connected, set_properties

Settings = vtkTimeWeightedTetrahedraMapper
# Two adjacent temperature intervals around a hot disk. Colors are rows of value, red, green, blue, and
# opacities are rows of value, opacity.
COMMON = {
    "data": "disk_out_ref", "array": "Temp", "intervals": [[360.0, 480.0], [480.0, 800.0]], "size": [400, 300],
    "background": [0.925, 0.929, 0.933],
    "camera": {"position": [15.0, -18.0, 11.0], "focus": [0.0, 0.0, 1.5], "up": [0.0, 0.0, 1.0], "angle": 30.0},
    "unit": 2.0, "blend": Settings.AUTOMATIC_BLEND, "sort": Settings.AUTOMATIC_SORT,
    "integration": Settings.LINEAR_SEGMENT, "path": Settings.AUTOMATIC_PATH, "delta_t": "DeltaT", "priorities": []}
BY_TEMPERATURE = {
    "color_by": ["POINTS", "Temp"],
    "colors": [[360.0, 0.23, 0.30, 0.75], [500.0, 0.87, 0.87, 0.87], [800.0, 0.71, 0.02, 0.15]],
    "opacities": [[360.0, 0.1], [480.0, 0.4], [800.0, 2.0]]}
BY_INTERVAL = {
    "color_by": ["CELLS", "IntervalId"], "colors": [[0.0, 0.22, 0.44, 0.72], [1.0, 0.93, 0.69, 0.26]],
    "opacities": [[0.0, 0.4], [1.0, 0.8]]}
# Moving vortex tubes that appear and fade: green early, yellow in between, red late, and denser
# where they stay longer.
BY_TIME = {
    "source": "AnalyticField",
    "source_properties": {
        "Field": vtkAnalyticFieldSource.VORTEX, "WholeExtent": [0, 71] * 3, "Bounds": [-0.9, 0.9] * 3,
        "NumberOfTimeSteps": 3, "TimeRange": [0.0, 2.0]},
    "properties": {"Intervals": [0.4, 0.8]}, "size": [600, 450], "camera": gyroid_camera(30.0),
    "color_by": ["POINTS", "Time"],
    "colors": [[0.0, 0.05, 0.60, 0.25], [1.0, 0.98, 0.85, 0.20], [2.0, 0.80, 0.08, 0.10]],
    "opacities": [[0.0, 0.5], [2.0, 0.5]], "unit": 0.012}
# Two stream volumes around a sphere from an upstream rectangle, colored by advection time.
FLOW = {
    "source": "AnalyticFlow",
    "source_properties": {
        "Field": vtkAnalyticFlowSource.SPHERE, "WholeExtent": [0, 39] * 3, "Bounds": [-1.0, 1.0] * 3},
    "surfaces": [{"kind": "Rectangle", "properties": {
        "Center": [-0.875, 0.0, 0.0], "Normal": [1.0, 0.0, 0.0], "Lengths": [1.5, 1.5]}}],
    "meshes": [], "field": {}, "mapping": {"Formula": "v"},
    "volume": {"Intervals": [0.3, 0.45, 0.55, 0.7], "TimeRange": [0.1, 1.5]}, "size": [480, 360],
    "camera": {"position": [1.5, -4.5, 2.0], "focus": [0.0, 0.0, 0.0], "up": [0.0, 0.0, 1.0], "angle": 30.0},
    "color_by": ["POINTS", "AdvectionTime"],
    "colors": [[0.1, 0.10, 0.25, 0.70], [0.8, 0.90, 0.90, 0.85], [1.5, 0.75, 0.20, 0.10]],
    "opacities": [[0.1, 0.6], [1.5, 0.9]], "unit": 0.2}
CASES = [{**COMMON, **colors, **changes, "name": name} for name, colors, changes in (
    ("by-temperature", BY_TEMPERATURE, {}),
    ("averaged-unsorted", BY_TEMPERATURE, {"integration": Settings.AVERAGE_COLOR, "sort": Settings.NO_SORT}),
    ("extent-in-time", BY_TEMPERATURE, {"delta_t": "AsH3", "unit": 0.1}),
    ("by-interval", BY_INTERVAL, {"sort": Settings.CENTROID_SORT}),
    ("outer-first", BY_INTERVAL, {"blend": Settings.PRIORITY_BLEND, "priorities": [[0, 2.0]]}),
    ("opengl", BY_INTERVAL, {"path": Settings.OPENGL_PATH, "blend": Settings.OPTICAL_DEPTH_BLEND}),
    ("by-time", BY_TIME, {}), ("flow", FLOW, {}))]


def extract(picture):
    if "volume" in picture:
        return pipelines.flow_volume(pipelines.inflow_mapping(pipelines.flow_field(picture), picture), picture)
    if "source" in picture:
        return pipelines.time_varying_volume(picture)
    data = pipelines.read_data(picture["data"] + ".vtu")
    return pipelines.interval_volume(data, picture["array"], picture["intervals"])


def draw(picture, _folder):
    mapper = connected(vtkTimeWeightedTetrahedraMapper(), extract(picture))
    kind, array = picture["color_by"]
    if kind == "CELLS":
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(array)
    set_properties(mapper, {
        "BlendMode": picture["blend"], "SortMode": picture["sort"], "IntegrationMode": picture["integration"],
        "RenderPath": picture["path"]})
    if picture["delta_t"] != "DeltaT":
        mapper.SetDeltaTArrayName(picture["delta_t"])
    for priority in picture["priorities"]:
        mapper.SetLayerPriority(*priority)
    return make_renderer(make_volume(mapper, picture))


write_images(sys.argv[1], "representation.json", CASES, draw)
