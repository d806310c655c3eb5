# SPDX-License-Identifier: BSD-3-Clause
"""The pieces of a parallel run give the same simplices, as a set, as one process, and tell how they share
the work.

Arguments: `write` or `compare`, and the file of simplices that one process wrote.
"""

from collections import Counter
import sys

import numpy
from paraview import servermanager, simple

from plugin_testing import as_set, fetch, interval_volume, open_data, run, temporal_source, time_varying_volume
from simplex_measures import simplices

FIELD = {"WholeExtent": [0, 23, 0, 19, 0, 19], "Bounds": [-0.5, 0.5, -0.4, 0.4, -0.4, 0.4]}
IN_TIME = {"Intervals": [0.3, 0.5, 0.5, 0.8], "GenerateSimplices": True}


# ParaView 6.1 calls it otherwise than 5.11 and 5.13.
ghost_cells = getattr(simple, "GhostCells", None) or simple.GhostCellsGenerator


def volumes(mode):
    """Name, extraction and the port whose output is compared; to compare, the unstructured grids are
    read in pieces."""
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
    """How many rows are only in the first, and only in the second; a repeated row counts."""
    counted = [Counter(map(bytes, numpy.ascontiguousarray(part))) for part in (expected, rows)]
    return tuple(sum((counted[a] - counted[1 - a]).values()) for a in (0, 1))


def check_balance(checks, name, volume, ranks):
    """What the Information panel shows of the balance."""
    fields = volume.FieldData
    if ranks == 1:
        checks.equal(fields["LoadBalance"], None, f"{name}: balance of one process")
        return
    least, most = fields["CellsOfProcesses"].GetRange()
    balance, same = fields["LoadBalance"].GetRange()
    checks.equal(balance, same, f"{name}: the balance is the same in all processes")
    print(f"{name}: {least:.0f} to {most:.0f} cells of a process, balance {balance:.3f}")
    checks.that(0 < least <= most and 1.0 <= balance <= ranks, f"{name}: balance {balance}")


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
        checks.that(ranks > 1, "several processes compare")
        expected = numpy.load(path)
        for name, rows in found.items():
            missing, extra = differences(expected[name], rows)
            checks.equal((missing, extra), (0, 0), f"{name}: simplices missing and extra")


run(main)
