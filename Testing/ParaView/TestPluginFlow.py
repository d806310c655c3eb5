# SPDX-License-Identifier: BSD-3-Clause
"""Tests that implicit flow fields, inflow mappings and flow volumes in ParaView equal the results of the C++
classes, with several surfaces, meshes, vortex axes and images, and all properties.
"""

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from extraction_measures import check_sum, compare
from flow_testing import (
    analytic_flow, flow_field, flow_volume, inflow_mapping, stream_lic, stream_texture, vortex_axis)
from plugin_testing import fetch, read_extractions, run
from simplex_measures import counts

OUTPUTS = (("volume", "IntervalId"), ("stream surfaces", "StreamSurfaceId"),
           ("time surfaces", "TimeSurfaceId"))


def compare_samples(checks, name, data, expected):
    arrays = data.GetPointData()
    checks.equal(data.GetNumberOfPoints(), expected["number"], f"{name}, samples")
    checks.equal(counts(arrays.GetArray("FlowStatus")), expected["statuses"], f"{name}, statuses")
    checks.equal(counts(arrays.GetArray("TerminationId")), expected["ids"], f"{name}, ids")
    parameters = vtk_to_numpy(arrays.GetArray("TerminationUV"))
    for what, values in (
            ("u", parameters[:, 0]), ("v", parameters[:, 1]),
            ("time", vtk_to_numpy(arrays.GetArray("AdvectionTime"))),
            ("inflow", vtk_to_numpy(arrays.GetArray("Inflow")))):
        check_sum(checks, values[numpy.isfinite(values)], expected[what], f"{name}, {what}")


def compare_texture(checks, name, flow, volume, extraction):
    """Compares texture coordinates and LIC of the stream surfaces."""
    expected = extraction["textured"]
    arrays = fetch(stream_texture(volume, extraction)).GetPointData()
    checks.equal(arrays.GetTCoords().GetName(), "StreamTexture", f"{name}, texture coordinates")
    checks.equal(counts(arrays.GetArray("ContourId")), expected["contours"], f"{name}, contours")
    coordinates = vtk_to_numpy(arrays.GetTCoords())
    check_sum(checks, coordinates[:, 0], expected["length"], f"{name}, sum of the lengths along contours")
    check_sum(checks, coordinates[:, 1], expected["time"], f"{name}, sum of the times")
    values = fetch(stream_lic(volume, flow, extraction)).GetPointData().GetArray("LIC")
    check_sum(checks, vtk_to_numpy(values).astype(float), extraction["lic_sum"], f"{name}, LIC")


def repeat(checks, name, extraction):
    flow = analytic_flow(extraction)
    mapping = inflow_mapping(flow_field(flow, extraction), extraction)
    compare_samples(checks, name, fetch(mapping), extraction["points"])
    volume = flow_volume(mapping, extraction)
    for port, (output, id_array) in enumerate(OUTPUTS):
        found = fetch(volume, port)
        compare(checks, f"{name}, {output}", found, extraction["outputs"][port], id_array)
    if "texture" in extraction:
        compare_texture(checks, name, flow, volume, extraction)
    search = simple.FlowCriticalPoints(Input=flow)
    # Some fields have no critical points, which causes a warning.
    warnings = []
    search.GetClientSideObject().AddObserver("WarningEvent", lambda *event: warnings.append(event))
    types = fetch(search).GetPointData().GetArray("CriticalPointType")
    checks.equal(len(warnings) > 0, not extraction["critical_points"], f"{name}, warning")
    checks.equal(counts(types), extraction["critical_points"], f"{name}, critical points")
    if "axis" in extraction:
        axis = fetch(vortex_axis(flow, extraction))
        checks.equal(axis.GetNumberOfPoints(), extraction["axis_points"], f"{name}, points of the axis")


def main(checks):
    extractions = read_extractions("flow.json")
    for number, extraction in enumerate(extractions):
        name = f"{number}: flow {extraction['source_properties']['Field']}"
        print(name, flush=True)
        repeat(checks, name, extraction)


run(main)
