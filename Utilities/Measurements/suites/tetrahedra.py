# SPDX-License-Identifier: BSD-3-Clause
"""Suite tetrahedra: vtkTimeWeightedTetrahedraMapper."""

from measured_cells import count, error_of, joined, peer_time, ratio, time
from measured_tables import Lines, Table

from .spread import single

PEER = "projectedtetrahedra"
SIZES = {"gyroid-0.3M": "0.3 M", "gyroid-2M": "2 M", "gyroid-8M": "8 M"}
MODES = ("composite, centroid sort", "composite, MPVONC sort", "composite", "composite, unsorted", "optical depth",
         "additive", "maximum intensity", "priority, four layers")
WORDS = {"composite": "composite (as chosen)"}
MAPPERS = {"software": "software", "software, average colour": "software, average colour", "opengl": "OpenGL",
           "opengl, average colour": "OpenGL, average colour", PEER: "`vtkProjectedTetrahedraMapper`",
           "raycast": "`vtkUnstructuredGridVolumeRayCastMapper`",
           "zsweep": "`vtkUnstructuredGridVolumeZSweepMapper`"}

# Speed rows have no error: the same methods have rows with one.
NO_ERROR = {"error": None}

TABLES = {
    "tetrahedra.speed": Lines("tetrahedra", [
        (words, joined("{} ({})", ratio(case=case, peer=PEER, **NO_ERROR), time(case=case, peer=PEER, **NO_ERROR)))
        for case, words in SIZES.items()],
        [(f"{path}, {WORDS.get(mode, mode)}", {"method": path, "parameter": mode})
         for path in ("software", "opengl") for mode in MODES], head="path, order"),
    "tetrahedra.peer": Table("tetrahedra", [("`vtkProjectedTetrahedraMapper`", peer_time())], head="tetrahedra",
                             names=SIZES, method="software", parameter="composite", peer=PEER, **NO_ERROR),
    "tetrahedra.error": Table("tetrahedra", [
        (f"{cubes}³ cubes", joined("{} ({})", error_of(parameter=cubes), time(parameter=cubes)))
        for cubes in (8, 16, 32, 48)], head="mapper", by="method", names=MAPPERS,
        parameter=lambda parameter: isinstance(parameter, int)),
}


def exponent(method):
    return single(count("exponent"), method=method, case="gyroid",
                  parameter=None if method == PEER else "composite")


VALUES = {f"tetrahedra.exponent-{method}": ("tetrahedra", exponent(method))
          for method in ("software", "opengl", PEER)}
