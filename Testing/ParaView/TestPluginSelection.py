# SPDX-License-Identifier: BSD-3-Clause
"""Tests selection in Interval Volume: the ids of hovered cells and points against rays through the input, rubber bands and
frusta.
"""

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCollection
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkMultiBlockDataSet, vtkPartitionedDataSet
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from plugin_images import add_array, color_by, coordinates, image, look_at, plain_view, producer
from plugin_testing import open_data, run

STEP = 29  # distance of the hovered pixels


def hexahedra(side, origin=(0.0, 0.0, 0.0)):
    """Returns a grid of hexahedra."""
    append = vtkAppendFilter()
    append.AddInputData(image(side, origin))
    append.Update()
    grid = append.GetOutput()
    points = coordinates(grid)
    add_array(grid, "value", points[:, 0] + 0.1 * points[:, 1])
    return grid


def blocks(kind):
    data = kind()
    parts = [hexahedra(5), hexahedra(4, (4.5, 0.0, 0.5))]
    for i, part in enumerate(parts):
        if kind is vtkMultiBlockDataSet:
            data.SetBlock(2 * i, part)  # block 1 is empty
        else:
            data.SetPartition(i, part)
    return data


def leaves(data):
    """Returns the composite indices and the datasets of all leaves."""
    if isinstance(data, vtkDataSet):
        return [(0, data)]
    found = []
    at = data.NewIterator()
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        found.append((at.GetCurrentFlatIndex(), at.GetCurrentDataObject()))
        at.GoToNextItem()
    return found


def triangles(grid):
    """Returns the corners of the triangles of a grid's surface, and the cells that they belong to."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.PassThroughCellIdsOn()
    split = vtkTriangleFilter()
    split.SetInputConnection(surface.GetOutputPort())
    split.Update()
    output = split.GetOutput()
    ids = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return coordinates(output)[ids], vtk_to_numpy(output.GetCellData().GetArray("vtkOriginalCellIds"))


class Rays:
    """Finds the first cell on the view ray of a pixel."""

    def __init__(self, view, data):
        renderer = view.SMProxy.GetRenderer()
        camera = renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1.0, 1.0)
        self.clip_from_world = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        self.size = numpy.array(renderer.GetSize())
        self.surfaces = [(index, leaf, *triangles(leaf)) for index, leaf in leaves(data)]

    def to_world(self, x, y, depth):
        across, up = 2.0 * (numpy.array([x, y]) + 0.5) / self.size - 1.0
        point = numpy.linalg.solve(self.clip_from_world, [across, up, depth, 1.0])
        return point[:3] / point[3]

    def to_display(self, point):
        clip = self.clip_from_world @ [*point, 1.0]
        return 0.5 * (clip[:2] / clip[3] + 1.0) * self.size

    def first(self, x, y):
        """Returns the composite index, the cell, its block and the corners of the first triangle on the ray, or None."""
        begin, end = self.to_world(x, y, -1.0), self.to_world(x, y, 1.0)
        best = None
        for index, leaf, corners, cells in self.surfaces:
            fractions = numpy.linalg.solve(
                numpy.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0],
                             numpy.broadcast_to(begin - end, (len(cells), 3))], axis=2),
                (begin - corners[:, 0])[..., None])[..., 0]
            inside = (fractions[:, 0] > 0) & (fractions[:, 1] > 0) & (fractions[:, 0] + fractions[:, 1] < 1)
            for triangle in numpy.flatnonzero(inside):
                at = fractions[triangle, 2]
                if best is None or at < best[0]:
                    best = (at, index, int(cells[triangle]), leaf, corners[triangle])
        return best and best[1:]


def hover(view, x, y, of_points=False):
    """Returns (composite index, id) of what ParaView selects at a pixel, or None."""
    found, sources = vtkCollection(), vtkCollection()
    select = view.SMProxy.SelectSurfacePoints if of_points else view.SMProxy.SelectSurfaceCells
    select([x, y, x, y], found, sources, False)
    if sources.GetNumberOfItems() == 0:
        return None
    ids = sources.GetItemAsObject(0).GetProperty("IDs")
    values = [ids.GetElement(i) for i in range(ids.GetNumberOfElements())]
    return (values[0] if len(values) == 3 else 0, values[-1]) if values else None


def show(source, array):
    """Shows a source with a nearly opaque medium, so that the first cell on a ray is seen."""
    view = plain_view()
    display = simple.Show(source, view)
    display.SetRepresentationType("Interval Volume")
    color_by(display, array)
    opacities = display.ScalarOpacityFunction
    opacities.Points = [-1e9, 1.0, 0.5, 0.0, 1e9, 1.0, 0.5, 0.0]
    display.IntervalOpacityUnitDistance = 1e-5
    look_at(view)
    simple.Render(view)
    view.InteractionMode = "Selection"
    return view, display


def check_hover(checks, source, array, name):
    """Compares hovered cells and points with rays through the data."""
    view, _ = show(source, array)
    rays = Rays(view, source.GetClientSideObject().GetOutputDataObject(0))
    hits = different = corners = 0
    for x in range(STEP // 2, view.ViewSize[0], STEP):
        for y in range(STEP // 2, view.ViewSize[1], STEP):
            expected = rays.first(x, y)
            found = hover(view, x, y)
            hits += expected is not None
            different += found != (expected and expected[:2])
            if found != (expected and expected[:2]):
                print(name, x, y, "found", found, "expected", expected and expected[:2])
            if expected is None:
                continue
            index, cell, leaf, _ = expected
            ids = leaf.GetCell(cell).GetPointIds()
            for k in range(ids.GetNumberOfIds()):
                at = [int(value) for value in rays.to_display(leaf.GetPoint(ids.GetId(k)))]
                hit = rays.first(*at)
                # A corner at the back of the cell is hidden.
                is_front = hit and numpy.abs(hit[3] - leaf.GetPoint(ids.GetId(k))).sum(axis=1).min() == 0
                if is_front and hit[:2] == (index, cell) and corners < 10:
                    corners += 1
                    checks.equal(hover(view, *at, True), (index, ids.GetId(k)), f"{name}, point at {at}")
    print(f"{name}: {hits} of hovered pixels show cells, {different} differ; {corners} corners")
    checks.that(hits > 20 and corners > 2, f"{name}, {hits} cells and {corners} corners are hovered")
    checks.equal(different, 0, f"{name}, cells that differ")
    simple.Delete(view)


def selected(source):
    """Returns the extracted selection."""
    extract = simple.ExtractSelection(Input=source)
    extract.UpdatePipeline()
    return extract.GetClientSideObject().GetOutputDataObject(0)


def check_regions(checks, volume, image_data):
    """Tests rubber bands, frusta and the array OriginCell of the extracted cells."""
    view, _ = show(volume, ["POINTS", "RTData"])
    view.InteractionMode = "3D"
    simple.SelectSurfaceCells(Rectangle=[0, 0, 299, 299], View=view)
    seen = selected(volume)
    drawn = volume.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    checks.that(100 < seen.GetNumberOfCells() < 0.7 * drawn, f"{seen.GetNumberOfCells()} of {drawn} cells are seen")
    origins = seen.GetCellData().GetArray("OriginCell")
    outside = 0
    for i in range(seen.GetNumberOfCells()):
        center = numpy.mean([seen.GetCell(i).GetPoints().GetPoint(k) for k in range(4)], axis=0)
        box = image_data.GetCell(origins.GetValue(i)).GetBounds()
        outside += any(not box[2 * k] <= center[k] <= box[2 * k + 1] for k in range(3))
    checks.equal(outside, 0, "tetrahedra outside of their source cells")
    simple.SelectCellsThrough(Rectangle=[0, 0, 299, 299], View=view)
    checks.equal(selected(volume).GetNumberOfCells(), drawn, "cells in the frustum of the view")
    simple.ClearSelection()
    simple.Delete(view)


def main(checks):
    wavelet = open_data("wavelet")
    volume = simple.IntervalVolume(Input=wavelet)
    volume.Intervals = [120.0, 180.0]
    volume.GenerateOriginArrays = 1
    volume.UpdatePipeline()
    check_hover(checks, volume, ["POINTS", "RTData"], "tetrahedra")
    check_regions(checks, volume, wavelet.GetClientSideObject().GetOutputDataObject(0))
    check_hover(checks, producer(hexahedra(5)), ["POINTS", "value"], "hexahedra")
    for kind in (vtkMultiBlockDataSet, vtkPartitionedDataSet):
        check_hover(checks, producer(blocks(kind)), ["POINTS", "value"], kind.__name__)


run(main)
