# SPDX-License-Identifier: BSD-3-Clause
"""Tests that filters accept data that have only cell arrays, select a cell array by default, and give the result of
Cell Data to Point Data. Filters whose input has no array are disabled.
"""

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_testing import check_inputs, fetch, open_data, run, set_properties, temporal_source, warnings_of

SCALAR_FILTERS = {
    "IntervalVolume": {},
    "IsotableContour": {},
    "TimeVaryingIntervalVolume": {"Boundaries": ["Volume at end"], "GenerateSimplices": True},
}
VECTOR_FILTERS = {
    "ImplicitFlowField": {"DomainFaces": True, "CriticalPointSpheres": True},
    "FlowBoundary": {},
    "FlowCriticalPoints": {},
    "VortexAxis": {},
}


def to_cells(source):
    """Returns the data with cell arrays only."""
    cells = simple.PointDatatoCellData(Input=source, ProcessAllArrays=True)
    cells.UpdatePipeline()
    return cells


def to_points(cells):
    points = simple.CellDatatoPointData(Input=cells, ProcessAllArrays=True, PassCellData=True)
    points.UpdatePipeline()
    return points


def arrays_of(proxy, port):
    """Returns all arrays of an output by association and name, with the points."""
    grid = fetch(proxy, port)
    if grid.IsA("vtkImageData"):
        arrays = {("points", ""): grid.GetDimensions()}
    else:
        points = grid.GetPoints()
        arrays = {("points", ""): vtk_to_numpy(points.GetData()) if points else numpy.empty(0)}
    for kind, attributes in (("point", grid.GetPointData()), ("cell", grid.GetCellData())):
        for index in range(attributes.GetNumberOfArrays()):
            array = attributes.GetArray(index)
            arrays[kind, array.GetName()] = vtk_to_numpy(array)
    return arrays


def check_equal(checks, proxy, reference, ports, what):
    for port in range(ports):
        found, expected = arrays_of(proxy, port), arrays_of(reference, port)
        checks.equal(sorted(found), sorted(expected), f"{what}, arrays at port {port}")
        for key in expected:
            checks.that(
                numpy.array_equal(found.get(key), expected[key]), f"{what}, {key} at port {port}")
    checks.that(fetch(proxy).GetNumberOfPoints() > 0, f"{what} has an output")


def selection_of(proxy):
    """Returns the name of the property that selects the array."""
    return next(name for name in ("Scalars", "ContourBy", "Vectors") if name in proxy.ListProperties())


def range_over_time(source, array):
    """Returns the range of a cell array over all time steps, or over the only one."""
    ranges = []
    times = list(getattr(source.Input, "TimestepValues", None) or [0.0])
    for time in times[::-1]:
        source.UpdatePipeline(time)
        ranges.append(source.CellData[array].GetRange())
    return min(low for low, _ in ranges), max(high for _, high in ranges)


def create(name, **inputs):
    """Creates a filter. An active source would be its first input, and determine the default array."""
    simple.SetActiveSource(None)
    return getattr(simple, name)(**inputs)


def check_filter(checks, name, properties, cells, points, array):
    """Tests the default selection, and that the output equals the output for the point array."""
    proxy = create(name, Input=cells)
    reference = create(name, Input=points)
    selection = selection_of(proxy)
    checks.equal(list(proxy.GetPropertyValue(selection)), ["CELLS", array], f"{name}, default array")
    checks.equal(list(reference.GetPropertyValue(selection)), ["POINTS", array], f"{name}, point arrays first")
    for one in (proxy, reference):
        set_properties(one, properties)
    for value in ("Intervals", "Isosurfaces"):
        if value in proxy.ListProperties():
            low, high = range_over_time(cells, array)
            count = len(proxy.GetPropertyValue(value))
            middle = [low + (high - low) * part for part in (0.45, 0.6)][:count]
            checks.that(
                all(low <= one <= high for one in proxy.GetPropertyValue(value)), f"{name}, proposed {value}")
            set_properties(proxy, {value: middle})
            set_properties(reference, {value: middle})
    with warnings_of(proxy, ("ErrorEvent",)) as messages:
        proxy.UpdatePipeline()
    checks.equal(messages, [], f"{name}, errors")
    check_equal(checks, proxy, reference, proxy.SMProxy.GetNumberOfOutputPorts(), name)
    # The same name as a point array in a script, as for Contour.
    set_properties(proxy, {selection: ["POINTS", array]})
    with warnings_of(proxy, ("ErrorEvent",)) as messages:
        proxy.UpdatePipeline()
    checks.equal(messages, [], f"{name}, errors of a cell array selected as a point array")


def check_accepted(checks, names, accepted):
    for name in names:
        check_inputs(checks, name, accepted)


def main(checks):
    field = temporal_source("AnalyticField", {"Field": "Wave", "WholeExtent": [0, 15, 0, 9, 0, 8]})
    flow = temporal_source("AnalyticFlow", {"WholeExtent": [0, 16, 0, 16, 0, 16]})
    nothing = simple.Sphere()  # has only normals
    scalars, vectors = to_cells(field), to_cells(flow)
    wavelet = to_cells(open_data("wavelet"))
    names = list(SCALAR_FILTERS)
    check_accepted(checks, names, ((scalars, True), (wavelet, True), (nothing, False), (vectors, False)))
    check_accepted(
        checks, list(VECTOR_FILTERS), ((vectors, True), (wavelet, False), (scalars, False)))
    for name, properties in SCALAR_FILTERS.items():
        check_filter(checks, name, properties, scalars, to_points(scalars), "f")
    saddle = to_cells(temporal_source("AnalyticFlow", {"Field": "Saddle", "WholeExtent": [0, 17, 0, 17, 0, 17]}))
    for name, properties in VECTOR_FILTERS.items():
        cells = saddle if name == "FlowCriticalPoints" else vectors
        check_filter(checks, name, properties, cells, to_points(cells), "Velocity")
    lic = create("FlowLIC", Input=flow, Field=vectors)
    checks.equal(list(lic.Vectors), ["CELLS", "Velocity"], "FlowLIC, default array")
    reference = create("FlowLIC", Input=flow, Field=to_points(vectors))
    # ParaView adds an array of Field's selection to Input, which is therefore not compared.
    streaks = ("point", "LIC")
    checks.that(
        numpy.array_equal(arrays_of(lic, 0)[streaks], arrays_of(reference, 0)[streaks]), "FlowLIC, streaks")


run(main)
