# SPDX-License-Identifier: BSD-3-Clause
"""Tests that filters in ParaView start with values from the input's range, produce the selected outputs, and have
documentation.
"""

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_testing import check_documentation, check_inputs, check_menu, fetch, open_data, run, temporal_source, warnings_of

FLOAT_ROUNDING = 1e-7


def check_scalars(checks, name, wavelet):
    """Tests that the input accepts data with a one-component point array and groups of such data, but no
    other."""
    vectors = simple.Sphere()  # has only normals
    group = simple.GroupDatasets(Input=[wavelet])
    check_inputs(checks, name, ((wavelet, True), (group, True), (vectors, False)))


def boundary_kinds(volume):
    grid = fetch(volume, 1)
    if grid.GetNumberOfCells() == 0:
        return []
    return numpy.unique(vtk_to_numpy(grid.GetCellData().GetArray("BoundaryKind"))).tolist()


def check_boundaries(checks, volume):
    """Tests that boundaries are selected by name, and others are removed."""
    checks.equal(list(volume.Boundaries), [], "default boundaries")
    checks.equal(boundary_kinds(volume), [], "default kinds of boundaries")
    for kind, name in enumerate(volume.GetProperty("Boundaries").Available):
        volume.Boundaries = [name]
        checks.equal(boundary_kinds(volume), [kind], f"kinds of {name}")
    volume.Boundaries = ["Volume at end", "Lower surface at start"]
    checks.equal(boundary_kinds(volume), [0, 7], "kinds of two boundaries")
    volume.Boundaries = []
    checks.equal(boundary_kinds(volume), [], "kinds of no boundaries")


def check_in_time(checks, field):
    """Tests the filter over time steps."""
    ranges = []
    for time in field.TimestepValues:
        field.UpdatePipeline(time)
        ranges.append(field.PointData.GetArray("f").GetRange())
    lowest, highest = min(low for low, _ in ranges), max(high for _, high in ranges)
    volume = simple.TimeVaryingIntervalVolume(Input=field)
    checks.equal(list(volume.Scalars), ["POINTS", "f"], "scalars in time")
    checks.equal(list(volume.Intervals), [(lowest + highest) / 2, highest], "default interval in time")
    checks.equal(list(volume.TimeStepRange), [0, 2**31 - 1], "default time steps")
    checks.equal(volume.OutputPointsPrecision, "Same as input", "precision in time")
    for port, name in enumerate(("Tetrahedra", "Boundaries", "Simplices")):
        checks.equal(volume.SMProxy.GetOutputPortName(port), name, f"output port {port} in time")
    checks.that(fetch(volume).GetNumberOfCells() > 0, "the default interval has tetrahedra")
    volume.Intervals = [-0.15, 0.15]
    check_boundaries(checks, volume)
    simplex_slice = simple.SimplexTimeSlice(Input=simple.OutputPort(volume, 2))
    simplex_slice.Time = 0.4
    with warnings_of(simplex_slice) as messages:
        checks.equal(
            fetch(simplex_slice).GetNumberOfCells(), 0, "slice without 4-simplices")
    checks.one_message(messages, "GenerateSimplices", "slice without 4-simplices")
    volume.GenerateSimplices = True
    checks.that(fetch(volume, 2).GetNumberOfCells() > 0, "the output has 4-simplices")
    checks.equal(fetch(simplex_slice).GetPointData().GetArray("Time").GetRange(), (0.4, 0.4), "slice")
    simplex_slice.SliceAxis = "Y"
    simplex_slice.Position = 0.3
    along_y = fetch(simplex_slice)
    checks.that(along_y.GetNumberOfCells() > 0, "cells of a slice along y")
    checks.close(along_y.GetBounds()[3], along_y.GetPointData().GetArray("Time").GetRange()[1], 1e-6,
                 "time as the coordinate of a slice along y")
    simplex_slice.SliceAxis = "Time"
    volume.GenerateTetrahedra = False
    checks.equal(fetch(volume).GetNumberOfCells(), 0, "tetrahedra if they are off")
    volume.Intervals = []
    with warnings_of(volume) as messages:
        checks.equal(fetch(volume, 2).GetNumberOfCells(), 0, "4-simplices without an interval")
    checks.one_message(messages, "no interval is set", "no interval in time")
    for proxy in (volume, simplex_slice):
        check_documentation(checks, proxy)
        check_menu(checks, "filters", proxy.SMProxy.GetXMLName())
    check_scalars(checks, "TimeVaryingIntervalVolume", field)


def main(checks):
    wavelet = open_data("wavelet")
    lowest, highest = wavelet.PointData.GetArray("RTData").GetRange()
    center = (lowest + highest) / 2

    volume = simple.IntervalVolume(Input=wavelet)
    checks.equal(list(volume.Scalars), ["POINTS", "RTData"], "scalars")
    checks.equal(list(volume.Intervals), [center, highest], "default interval")
    checks.equal(list(volume.Criteria), [], "criteria")
    values = fetch(volume).GetPointData().GetArray("RTData").GetRange()
    for value, bound in zip(values, (center, highest)):
        checks.close(value, bound, FLOAT_ROUNDING, "range of the values in the default interval")
    checks.equal(volume.SMProxy.GetOutputPortName(0), "Tetrahedra", "output port 0")
    checks.equal(volume.SMProxy.GetOutputPortName(1), "Boundary", "output port 1")
    checks.equal(fetch(volume, 1).GetNumberOfCells(), 0, "boundary triangles are off by default")
    volume.Intervals = []
    with warnings_of(volume) as messages:
        checks.equal(fetch(volume).GetNumberOfCells(), 0, "tetrahedra without an interval")
    checks.one_message(messages, "no interval is set", "no interval")

    contour = simple.IsotableContour(Input=wavelet)
    checks.equal(list(contour.ContourBy), ["POINTS", "RTData"], "scalars of the contour")
    checks.equal(list(contour.Isosurfaces), [center], "default contour value")
    checks.that(fetch(contour).GetNumberOfCells() > 0, "the default contour has triangles")

    for proxy in (volume, contour):
        check_documentation(checks, proxy)
        check_menu(checks, "filters", proxy.SMProxy.GetXMLName())
        check_scalars(checks, proxy.SMProxy.GetXMLName(), wavelet)
    field = temporal_source("AnalyticField", {"Field": "Wave", "WholeExtent": [0, 15, 0, 7, 0, 7]})
    check_in_time(checks, field)


run(main)
