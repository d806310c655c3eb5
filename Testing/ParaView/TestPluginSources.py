# SPDX-License-Identifier: BSD-3-Clause
"""The sources tell ParaView their time steps and give their fields at any time."""

import math

from paraview import servermanager, simple

from plugin_testing import Checks, check_documentation, check_menu, fetch, load_plugin


def check_times(checks, source):
    name = source.SMProxy.GetXMLName()
    checks.equal(list(source.TimestepValues), [0.0, 1.0, 2.0], f"{name}, time steps")
    source.NumberOfTimeSteps = 5
    source.TimeRange = [1.0, 3.0]
    source.UpdatePipelineInformation()
    checks.equal(list(source.TimestepValues), [1.0, 1.5, 2.0, 2.5, 3.0], f"{name}, new time steps")


def check_wave(checks, source):
    """The values against the formula, between two time steps."""
    source.Field = "Wave"
    source.WholeExtent = [0, 8, 0, 6, 0, 4]
    source.Bounds = [-2.0, 2.0, -1.0, 1.0, -1.0, 1.0]
    source.OutputScalarType = "Double"
    source.UpdatePipeline(1.3)
    image = servermanager.Fetch(source)
    values = image.GetPointData().GetArray("f")
    checks.equal(image.GetNumberOfPoints(), 9 * 7 * 5, "points of the wave")
    for point in range(image.GetNumberOfPoints()):
        x, y, z = image.GetPoint(point)
        expected = z - 0.4 * math.cos(math.pi * (x + y / 4 - 1.3 / 2))
        checks.that(abs(values.GetValue(point) - expected) < 1e-12, f"wave at point {point}")


def check_motion(checks, source, array, interval):
    """There is an interval volume at each time, not the same one."""
    volumes = []
    for time in (1.0, 2.0):
        source.UpdatePipeline(time)
        volume = simple.IntervalVolume(Input=source)
        volume.Scalars = ["POINTS", array]
        volume.Intervals = interval
        volume.UpdatePipeline(time)
        volumes.append(servermanager.Fetch(volume).GetNumberOfCells())
    name = source.SMProxy.GetXMLName()
    checks.that(min(volumes) > 1000, f"{name} has tetrahedra")
    checks.that(volumes[0] != volumes[1], f"{name} moves")


def main():
    load_plugin()
    checks = Checks()
    field = simple.AnalyticField()
    cylinder = simple.TaperedCylinderWake()
    wing = simple.DeltaWingVortices()
    for source, kind, points in (
        (field, "vtkImageData", 64**3),
        (cylinder, "vtkStructuredGrid", 64 * 64 * 32),
        (wing, "vtkStructuredGrid", 111 * 126 * 51),
    ):
        data = fetch(source)
        name = source.SMProxy.GetXMLName()
        checks.equal(data.GetClassName(), kind, f"{name}, kind of data")
        checks.equal(data.GetNumberOfPoints(), points, f"{name}, points")
        check_documentation(checks, source)
        check_menu(checks, "sources", name)
        check_times(checks, source)
    check_motion(checks, field, "f", [0.5, 0.8])
    check_motion(checks, cylinder, "density", [0.9934, 0.9944])
    check_motion(checks, wing, "loss", [0.4, 0.7])
    check_wave(checks, field)
    checks.finish()


main()
