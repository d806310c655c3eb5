# SPDX-License-Identifier: BSD-3-Clause
"""Suite tables: the tables of cases."""

from measured_cells import count, joined, short
from measured_tables import Table

CELLS = {"tetrahedron": "tetrahedron", "hexahedron": "hexahedron", "wedge": "wedge", "pyramid": "pyramid",
         "tetrahedron-time": "tetrahedron × time", "hexahedron-time": "hexahedron × time",
         "4-simplex": "4-simplex", "5-simplex": "5-simplex"}
README_CELLS = ("tetrahedron", "hexahedron", "tetrahedron-time", "hexahedron-time")
MEAN = "{:.2f}".format


def simplices(method, stated=""):
    return joined("{}, {}", count(f"{stated}mean", MEAN, method=method), count(f"{stated}max", method=method))


COLUMNS = [("entries", count("entries", short, method="shipped")), ("simplices: mean, most", simplices("shipped")),
           ("in the source's order", simplices("source-order"))]
TABLES = {
    "tables.simplices": Table("tables", [*COLUMNS, ("as the source states", simplices("source-order", "stated_"))],
                              head="interval table", names=CELLS, case=lambda name: name in CELLS, method="shipped"),
    "tables.readme": Table("tables", COLUMNS, head="interval table", names=CELLS,
                           case=lambda name: name in README_CELLS, method="shipped"),
}
VALUES = {}
