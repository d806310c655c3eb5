# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the samples of an implicit flow field are distributed over the ranks of a parallel run, and that each
has the same result as in one process. The sizes of tetrahedra of flow volumes are equal too, except for cells cut
at a termination surface: the neighbors used to extrapolate past the surface may be in another piece.

Arguments: `write` or `compare`, and the file with the results of one process.
"""

import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from flow_testing import analytic_flow, flow_field, flow_volume, inflow_mapping
from plugin_testing import fetch, read_extractions, run
from simplex_measures import simplices, sizes

ARRAYS = ("FlowStatus", "TerminationId", "TerminationUV", "AdvectionTime", "Inflow")
RASTER = 1.7e-3  # rounds positions: an image fetched from a process has six digits of its origin
TOLERANCE = 1e-12  # relative error of a sum of sizes, which depends on the order
CUTS = 4e-3  # relative error with cells cut between two pieces; 2.4e-3 was measured


def pipelines():
    """Yields name, mapping and volume of the extractions, and of the first also on tetrahedra."""
    extractions = read_extractions("flow.json")
    for number, extraction in enumerate(extractions):
        kinds = ("grid", "tetrahedra") if number == 0 else ("grid",)
        for kind in kinds:
            flow = analytic_flow(extraction)
            if kind == "tetrahedra":
                flow = simple.Tetrahedralize(Input=flow)
                flow.UpdatePipeline()
            mapping = inflow_mapping(flow_field(flow, extraction), extraction)
            yield f"{number}, {kind}", mapping, flow_volume(mapping, extraction)


def rows(samples):
    """Returns position and results of each sample, without duplicates, in sorted order."""
    positions = [samples.GetPoint(i) for i in range(samples.GetNumberOfPoints())]
    columns = [numpy.round(numpy.divide(positions, RASTER)) + 0.0]  # no negative zero
    columns += [vtk_to_numpy(samples.GetPointData().GetArray(name)) for name in ARRAYS]
    table = numpy.column_stack([numpy.asarray(column, float) for column in columns])
    return numpy.unique(numpy.where(numpy.isnan(table), -1e300, table), axis=0)


def main(checks):
    mode, path = sys.argv[1:]
    ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    found = {}
    for name, mapping, volume in pipelines():
        pieces = [fetch(mapping, 0, rank) for rank in range(ranks)]
        numbers = [piece.GetNumberOfPoints() for piece in pieces]
        grids = [fetch(volume, 0, rank) for rank in range(ranks)]
        print(f"{name}: samples of each process:", *numbers, flush=True)
        checks.that(all(numbers), f"{name} has samples in every process")
        found[name] = numpy.concatenate([rows(piece) for piece in pieces])
        found[name] = numpy.unique(found[name], axis=0)
        checks.that(ranks == 1 or max(numbers) < len(found[name]), f"{name} is split")
        volumes = [sizes(simplices(piece)).sum() for piece in grids]
        found[f"{name}, size"] = numpy.array(sum(volumes))
    if mode == "write":
        checks.equal(ranks, 1, "processes that write")
        numpy.savez_compressed(path, **found)
    else:
        checks.equal(ranks, 4, "processes")
        expected = numpy.load(path)
        checks.equal(sorted(found), sorted(expected.files), "names of the results")
        for name in found:
            if name.endswith("size"):
                grids = name.startswith("0, ")
                checks.close(found[name], expected[name], TOLERANCE if grids else CUTS, name)
            else:
                checks.that(numpy.array_equal(found[name], expected[name]), f"{name}, samples")


run(main)
