# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the pieces of a parallel run have the same set of simplices as one process, and report the load
balance.

Arguments: `write` or `compare`, and the file with the simplices of one process.
"""

from collections import Counter
import sys

import numpy
from paraview import servermanager, simple

from plugin_testing import as_set, fetch, interval_volume, open_data, run, temporal_source, time_varying_volume
from simplex_measures import simplices

FIELD = {"WholeExtent": [0, 23, 0, 19, 0, 19], "Bounds": [-0.5, 0.5, -0.4, 0.4, -0.4, 0.4]}
IN_TIME = {"Intervals": [0.3, 0.5, 0.5, 0.8], "GenerateSimplices": True}


# The filter has another name in ParaView 6.1 than in 5.11 and 5.13.
ghost_cells = getattr(simple, "GhostCells", None) or simple.GhostCellsGenerator


def volumes(mode):
    """Yields name, extraction and compared output port. To compare, unstructured grids are read in pieces."""
    wavelet = open_data("wavelet")
    ghosts = ghost_cells(Input=wavelet)
    ghosts.UpdatePipeline()
    intervals = [(100.0, 140.0), (140.0, 180.0)]
    yield "wavelet", interval_volume(wavelet, "RTData", intervals), 0
    yield "wavelet with ghosts", interval_volume(ghosts, "RTData", intervals), 0
    for name, array, intervals in (
            ("disk_out_ref", "Temp", [(400.0, 500.0), (500.0, 700.0)]),
            ("post_tets", "Pressure", [(0.8, 1.1)])):
        file = name if mode == "write" else f"{name}_pieces.pvtu"
        yield name, interval_volume(open_data(file), array, intervals), 0
    field = temporal_source("AnalyticField", FIELD)
    ghosts = ghost_cells(Input=field)
    ghosts.UpdatePipeline()
    for name, source in ("field in time", field), ("field in time with ghosts", ghosts):
        in_time = time_varying_volume(source, IN_TIME)
        yield name, in_time, 0
        yield f"{name}, 4-simplices", in_time, 2


def differences(expected, rows):
    """Returns the number of rows only in the first and only in the second array, counting repeated rows."""
    counted = [Counter(map(bytes, numpy.ascontiguousarray(part))) for part in (expected, rows)]
    return tuple(sum((counted[a] - counted[1 - a]).values()) for a in (0, 1))


def check_balance(checks, name, volume, ranks):
    """Checks the balance shown in the Information panel."""
    fields = volume.FieldData
    if ranks == 1:
        checks.equal(fields["LoadBalance"], None, f"{name}: no balance with one process")
        return
    minimum, maximum = fields["CellsOfProcesses"].GetRange()
    balance, same = fields["LoadBalance"].GetRange()
    checks.equal(balance, same, f"{name}: equal balance in all processes")
    print(f"{name}: {minimum:.0f} to {maximum:.0f} cells per process, balance {balance:.3f}")
    checks.that(0 < minimum <= maximum and 1.0 <= balance <= ranks, f"{name}: balance {balance}")


def main(checks):
    mode, path = sys.argv[1:]
    found = {}
    ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    for name, volume, port in volumes(mode):
        volume.ReportLoadBalance = True
        pieces = [simplices(fetch(volume, port, rank)) for rank in range(ranks)]
        print(f"{name}: simplices of each process:", *map(len, pieces), flush=True)
        checks.that(all(map(len, pieces)), f"{name} has simplices in every process")
        found[name] = as_set(numpy.concatenate(pieces))
        check_balance(checks, name, volume, ranks)
    if mode == "write":
        checks.equal(ranks, 1, "processes that write")
        numpy.savez(path, **found)
    else:
        checks.that(ranks > 1, "comparing needs several processes")
        expected = numpy.load(path)
        for name, rows in found.items():
            missing, extra = differences(expected[name], rows)
            checks.equal((missing, extra), (0, 0), f"{name}: simplices missing and extra")


run(main)
