"""The pieces of a parallel run give the same tetrahedra, as a set, as one process.

Arguments: `write` or `compare`, and the file of tetrahedra that one process wrote.
"""

from collections import Counter
import sys

import numpy
from paraview import servermanager, simple

from plugin_testing import Checks, as_set, fetch, interval_volume, load_plugin, open_data, simplices


def inputs(mode):
    """Name, source, array and intervals; to compare, the unstructured grids are read in pieces."""
    wavelet = open_data("wavelet")
    ghosts = simple.GhostCellsGenerator(Input=wavelet)
    ghosts.UpdatePipeline()
    intervals = [(100.0, 140.0), (140.0, 180.0)]
    yield "wavelet", wavelet, "RTData", intervals
    yield "wavelet with ghosts", ghosts, "RTData", intervals
    for name, array, intervals in (
            ("disk_out_ref", "Temp", [(400.0, 500.0), (500.0, 700.0)]),
            ("post_tets", "Pressure", [(0.8, 1.1)])):
        file = name if mode == "write" else f"{name}_pieces.pvtu"
        yield name, open_data(file), array, intervals


def differences(expected, rows):
    """How many rows are only in the first, and only in the second; a repeated row counts."""
    counted = [Counter(map(bytes, numpy.ascontiguousarray(part))) for part in (expected, rows)]
    return tuple(sum((counted[a] - counted[1 - a]).values()) for a in (0, 1))


def main():
    mode, path = sys.argv[1:]
    load_plugin()
    checks = Checks()
    found = {}
    ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    for name, source, array, intervals in inputs(mode):
        volume = interval_volume(source, array, intervals)
        pieces = [simplices(fetch(volume, rank=rank)) for rank in range(ranks)]
        print(f"{name}: tetrahedra of each process:", *map(len, pieces), flush=True)
        checks.that(all(map(len, pieces)), f"{name} has tetrahedra in every process")
        found[name] = as_set(numpy.concatenate(pieces))
    if mode == "write":
        checks.equal(ranks, 1, "processes that write")
        numpy.savez(path, **found)
    else:
        checks.that(ranks > 1, "several processes compare")
        expected = numpy.load(path)
        for name, rows in found.items():
            missing, extra = differences(expected[name], rows)
            checks.equal((missing, extra), (0, 0), f"{name}: tetrahedra missing and extra")
    checks.finish()


main()
