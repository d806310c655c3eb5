# SPDX-License-Identifier: BSD-3-Clause
"""Suite contour: vtkIsotableContour."""

from measured_cells import count, ratio
from measured_tables import Table

from .data_names import DATA

ONE = {"parameter": "1 thread"}
HEXAHEDRA = {"method": "isotable-hexahedra", **ONE}

TABLES = {
    "contour.speed": Table("contour", [
        ("triangles", count("triangles", peer="contour3dlinear", **HEXAHEDRA)),
        ("hexahedra, points not shared: against `vtkContour3DLinearGrid`",
         ratio(peer="contour3dlinear", method="isotable-hexahedra-unmerged", **ONE)),
        ("points shared, against its points not shared", ratio(peer="contour3dlinear", **HEXAHEDRA)),
        ("points shared by both", ratio(peer="contour3dlinear-merge", **HEXAHEDRA)),
        ("image data: against `vtkFlyingEdges3D`", ratio(method="isotable-image", peer="flyingedges", **ONE))],
        head="data", names=DATA, **HEXAHEDRA),
}
VALUES = {}
