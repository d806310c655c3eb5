# SPDX-License-Identifier: BSD-3-Clause
"""Tetrahedral Mesher in ParaView: volumes, bounds, grids, and arrays."""

import numpy
from paraview import simple

from plugin_testing import check_documentation, check_menu, fetch, open_file, run, warnings_of
from simplex_measures import simplices, sizes


def volumes(mesh):
    """Returns the volume of each tetrahedron."""
    return sizes(simplices(mesh))


def check_sphere(checks):
    """Tests a triangulated sphere: the volume of the tetrahedra must equal its volume by the divergence
    theorem."""
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    surface = fetch(sphere)
    corners = numpy.array([[surface.GetCell(i).GetPoints().GetPoint(j) for j in range(3)]
                           for i in range(surface.GetNumberOfCells())])
    expected = abs(numpy.linalg.det(corners).sum()) / 6.0
    mesher = simple.TetrahedralMesher(Input=sphere)
    check_documentation(checks, mesher)
    check_menu(checks, "filters", "TetrahedralMesher")
    plain = fetch(mesher)
    checks.close(volumes(plain).sum(), expected, 1e-6, "volume of the sphere")
    largest = expected / 500.0
    mesher.MaximumVolume = largest
    fine = fetch(mesher)
    checks.that(volumes(fine).max() <= largest * 1.0001, "largest volume of a tetrahedron")
    checks.close(volumes(fine).sum(), expected, 1e-6, "volume of the fine sphere")
    checks.that(fine.GetNumberOfCells() > max(500, plain.GetNumberOfCells()),
                "the bound increases the number of tetrahedra")
    checks.that(fine.GetCellData().GetArray("RegionId") is not None, "the mesh has RegionId")


def check_grid(checks):
    """Tests that hexahedra are split into tetrahedra of the same volume, which keep the array."""
    wavelet = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    grid = simple.AppendDatasets(Input=wavelet)
    mesh = fetch(simple.TetrahedralMesher(Input=grid))
    checks.close(volumes(mesh).sum(), 216.0, 1e-6, "volume of the grid")
    checks.that(mesh.GetPointData().GetArray("RTData") is not None, "array of the grid")


def check_collapsed(checks):
    """Tests a structured grid with collapsed cells, whose volume ParaView's tetrahedra give up to the diagonals of faces."""
    fin = open_file("bluntfin.vts")
    mesher = simple.TetrahedralMesher(Input=fin)
    with warnings_of(mesher, ("WarningEvent", "ErrorEvent")) as messages:
        mesher.UpdatePipeline()
    checks.one_message(messages, "faces meet themselves", "collapsed cells")
    expected = sizes(simplices(fetch(simple.Tetrahedralize(Input=fin)))).sum()
    checks.close(volumes(fetch(mesher)).sum(), expected, 1e-2, "volume of the collapsed grid")


def main(checks):
    check_sphere(checks)
    check_collapsed(checks)
    check_grid(checks)


run(main)
