# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the sources report their time steps to ParaView and provide their fields at any time."""

import math

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_testing import check_documentation, check_menu, fetch, run


def check_times(checks, source):
    name = source.SMProxy.GetXMLName()
    checks.equal(list(source.TimestepValues), [0.0, 1.0, 2.0], f"{name}, time steps")
    source.NumberOfTimeSteps = 5
    source.TimeRange = [1.0, 3.0]
    source.UpdatePipelineInformation()
    checks.equal(list(source.TimestepValues), [1.0, 1.5, 2.0, 2.5, 3.0], f"{name}, new time steps")


def check_wave(checks, source):
    """Tests values between two time steps against the formula."""
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
    """Tests that interval volumes at two times exist and differ."""
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
    checks.that(volumes[0] != volumes[1], f"{name} changes in time")


def values_of(source, array):
    """Returns the values of a point array, one row per point."""
    return vtk_to_numpy(fetch(source).GetPointData().GetArray(array)).copy()


def check_models(checks):
    """Tests that all models differ, have full and empty regions, and have the density as opacity of their
    colors."""
    source = simple.ConstructiveVolumeModel(Resolution=32)
    check_documentation(checks, source)
    check_menu(checks, "sources", "ConstructiveModelSource")
    seen = []
    for model in source.GetProperty("Model").Available:
        source.Model = model
        source.OutputMode = "Density"
        density = values_of(source, "Density")
        checks.that(density.min() == 0.0 and 0.0 < density.max() <= 1.0, 
                    f"{model}, densities: {density.min()} to {density.max()}")
        checks.that(not any(numpy.array_equal(density, other) for other in seen), f"{model} differs from other models")
        seen.append(density)
        source.OutputMode = "Color as Floats"
        colors = values_of(source, "Color")
        checks.that(numpy.array_equal(colors[:, 3], density), f"{model}, opacity of its colors")
    checks.equal(len(seen), 9, "number of models")


def check_turbulence(checks):
    """Tests that the noise depends on seed, sum and frequency, and has the requested extent."""
    source = simple.Turbulence(WholeExtent=[0, 20, 0, 16, 0, 12])
    check_documentation(checks, source)
    check_menu(checks, "sources", "TurbulenceSource")
    array = fetch(source).GetPointData().GetArray(0).GetName()
    values = [values_of(source, array)]
    checks.equal(len(values[0]), 21 * 17 * 13, "points of the turbulence")
    for name, value in (("Seed", source.Seed + 1), ("Sum", "Noise"), ("Frequency", 3.0)):
        before = source.GetProperty(name).GetData()
        setattr(source, name, value)
        values.append(values_of(source, array))
        checks.that(not numpy.array_equal(values[-1], values[0]), f"{name} changes the turbulence")
        setattr(source, name, before)
    checks.that(numpy.array_equal(values_of(source, array), values[0]), "restoring the settings restores the turbulence")


def main(checks):
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
    check_models(checks)
    check_turbulence(checks)


run(main)
