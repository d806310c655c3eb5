# SPDX-License-Identifier: BSD-3-Clause
"""Tests that Save Data offers slabs of interval volumes for data with time steps, and writes the filter's
output."""

import os
import shutil
import sys

import numpy
from paraview import servermanager, simple

from plugin_testing import as_set, fetch, leaves, run, temporal_source
from simplex_measures import simplices

KIND = "Interlume Slabs of Interval Volumes"


def kinds_for(proxy):
    """Returns the file types that Save Data offers for the output of a proxy."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    return factory.GetSupportedFileTypes(proxy.SMProxy, 0)


def all_simplices(parts):
    return as_set(numpy.concatenate([simplices(part) for part in parts]))


def main(checks):
    folder = sys.argv[1]
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    field = temporal_source("AnalyticField", {"Field": "Wave", "WholeExtent": [0, 15, 0, 7, 0, 7]})
    checks.that(KIND in kinds_for(field), "Save Data offers slabs")
    spheres = simple.GroupDatasets(Input=[simple.Sphere(), simple.Sphere()])
    spheres.UpdatePipeline()
    checks.that(KIND not in kinds_for(spheres), "Save Data does not offer slabs for composite data")

    low, high = field.PointData.GetArray(0).GetRange()
    writer = simple.CreateWriter(os.path.join(folder, "proposed.vtm"), field)
    checks.equal(writer.SMProxy.GetXMLName(), "TimeSlabWriter", "name of the writer")
    for value, expected, what in zip(writer.Intervals, (0.5 * (low + high), high), ("lower", "upper")):
        checks.close(value, expected, 1e-12, f"default {what} value")

    for name, settings in (("proposed", {}),
                           ("chosen", {"Intervals": [-0.5, 0.25, 0.25, 1.0], "TimeStepRange": [0, 1]})):
        path = os.path.join(folder, f"{name}.vtm")
        simple.SaveData(path, proxy=field, **settings)
        expected = simple.TimeVaryingIntervalVolume(Input=field, **{"Intervals": writer.Intervals, **settings})
        parts = list(leaves(fetch(simple.OpenDataFile(path))))
        last = min(expected.TimeStepRange[1], len(field.TimestepValues) - 1)
        checks.equal(len(parts), last, f"slabs of {name}")
        grid = fetch(expected)
        checks.that(grid.GetNumberOfCells() > 0, f"{name} produces tetrahedra")
        checks.that(numpy.array_equal(all_simplices(parts), all_simplices([grid])),
                    f"{name} has the tetrahedra of the filter")


run(main)
