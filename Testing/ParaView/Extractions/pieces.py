# SPDX-License-Identifier: BSD-3-Clause
"""Partitions an unstructured grid into pieces for several processes."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

SUMMARY = """<VTKFile type="PUnstructuredGrid" version="1.0">
<PUnstructuredGrid>
<PPointData Scalars="{array}" GlobalIds="{ids}">
<PDataArray type="{type}" Name="{array}" NumberOfComponents="1"/>
<PDataArray type="Int64" Name="{ids}" NumberOfComponents="1" IdType="1"/>
</PPointData>
<PCellData>
<PDataArray type="UInt8" Name="{ghosts}" NumberOfComponents="1"/>
</PCellData>
<PPoints>
<PDataArray type="{points}" Name="Points" NumberOfComponents="3"/>
</PPoints>
{pieces}
</PUnstructuredGrid>
</VTKFile>
"""


def named(array, name):
    array.SetName(name)
    return array


def type_name(values):
    """Returns the type name of a floating-point array in an XML file."""
    return f"Float{8 * values.itemsize}"


def make_piece(grid, array, is_own):
    """Returns the cells of a piece with their neighbors as ghost cells, and the points that they use."""
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    sizes = numpy.diff(offsets)
    is_touched = numpy.zeros(grid.GetNumberOfPoints(), bool)
    is_touched[corners[numpy.repeat(is_own, sizes)]] = True
    chosen = numpy.logical_or.reduceat(is_touched[corners], offsets[:-1])
    used = corners[numpy.repeat(chosen, sizes)]
    points = numpy.unique(used)[::-1]
    new_ids = numpy.empty(grid.GetNumberOfPoints(), numpy.int64)
    new_ids[points] = numpy.arange(len(points))

    piece, new_points, cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    new_points.SetData(numpy_to_vtk(vtk_to_numpy(grid.GetPoints().GetData())[points], deep=True))
    piece.SetPoints(new_points)
    cells.SetData(numpy_to_vtkIdTypeArray(numpy.concatenate([[0], numpy.cumsum(sizes[chosen])]), deep=True),
                  numpy_to_vtkIdTypeArray(new_ids[used], deep=True))
    types = vtk_to_numpy(grid.GetCellTypesArray())[chosen]
    piece.SetCells(numpy_to_vtk(types, deep=True), cells)
    data, own_data = grid.GetPointData(), piece.GetPointData()
    ids = numpy_to_vtkIdTypeArray(vtk_to_numpy(data.GetGlobalIds())[points], deep=True)
    own_data.SetGlobalIds(named(ids, data.GetGlobalIds().GetName()))
    values = vtk_to_numpy(data.GetArray(array))[points]
    own_data.SetScalars(named(numpy_to_vtk(values, deep=True), array))
    ghosts = numpy.where(is_own[chosen], 0, vtkDataSetAttributes.DUPLICATECELL).astype(numpy.uint8)
    piece.GetCellData().AddArray(named(numpy_to_vtk(ghosts, deep=True), vtkDataSetAttributes.GhostArrayName()))
    return piece


def write_pieces(grid, array, count, path):
    """Partitions a grid along x into slabs with equal numbers of cells. Writes a .pvtu file with one piece per
    process; `path` has no extension. A piece has the point array and the global point ids of the grid, and the
    cells that share a point with it as ghost cells. Its points are in reverse order, so that an extraction must
    use the global ids to agree with one of the full grid.
    """
    points = vtk_to_numpy(grid.GetPoints().GetData())
    x = points[vtk_to_numpy(grid.GetCells().GetConnectivityArray()), 0].astype(float)
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
    centers = numpy.minimum.reduceat(x, starts) + numpy.maximum.reduceat(x, starts)
    slabs = numpy.empty(len(centers), int)
    slabs[numpy.argsort(centers, kind="stable")] = numpy.arange(len(centers)) * count // len(centers)
    names = [f"{path}_{slab}.vtu" for slab in range(count)]
    for slab, name in enumerate(names):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(make_piece(grid, array, slabs == slab))
        writer.SetDataModeToBinary()
        writer.SetFileName(name)
        assert writer.Write() == 1, f"cannot write {name}"
    with open(path + ".pvtu", "w", encoding="utf-8") as file:
        file.write(SUMMARY.format(
            array=array, ids=grid.GetPointData().GetGlobalIds().GetName(),
            type=type_name(vtk_to_numpy(grid.GetPointData().GetArray(array))),
            ghosts=vtkDataSetAttributes.GhostArrayName(), points=type_name(points),
            pieces="\n".join(f'<Piece Source="{name.rsplit("/", 1)[1]}"/>' for name in names)))
