# SPDX-License-Identifier: BSD-3-Clause
"""Suite tables: the tables of cases."""

from measured_cells import count, joined, short
from measured_tables import Table

CELLS = {"tetrahedron": "tetrahedron", "hexahedron": "hexahedron", "wedge": "wedge", "pyramid": "pyramid",
         "tetrahedron-time": "tetrahedron × time", "hexahedron-time": "hexahedron × time",
         "4-simplex": "4-simplex", "5-simplex": "5-simplex"}


def simplices(method):
    return joined("{}, {}", count("mean", lambda number: f"{number:.2f}", method=method), count("max", method=method))


TABLES = {
    "tables.simplices": Table("tables", [
        ("entries", count("entries", short, method="shipped")), ("simplices: mean, most", simplices("shipped")),
        ("in the source's order", simplices("source-order")),
        ("as the source states", joined("{}, {}", count("stated_mean", method="source-order"),
                                        count("stated_max", method="source-order")))],
        head="interval table", names=CELLS, case=lambda name: name in CELLS, method="shipped"),
}
VALUES = {}
