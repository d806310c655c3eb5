# SPDX-License-Identifier: BSD-3-Clause
"""What the examples put on stage: data, volumes of tetrahedra and of images, surfaces, lights."""

import os
from pathlib import Path

import numpy as np
from interlume import (
    vtkImplicitFlowField, vtkInflowMapping, vtkIntervalVolume, vtkShadowedSliceMapper,
    vtkTerminationPlane, vtkTimeWeightedTetrahedraMapper)
from stage import dot
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_TRIANGLE, vtkCellArray, vtkDataObject, vtkPiecewiseFunction, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkVolume, vtkVolumeProperty)

DATA = Path(os.environ.get("INTERLUME_DATA") or Path(__file__).parents[2] / "Data")

COLORS = [(0.220, 0.440, 0.720), (0.278, 0.655, 0.580), (0.929, 0.694, 0.263),
          (0.788, 0.286, 0.231), (0.494, 0.341, 0.600), (0.545, 0.565, 0.585)]


def read(name):
    """A file of the folder Data, or of the folder that INTERLUME_DATA names."""
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(str(DATA / name))
    reader.Update()
    return reader.GetOutput()


def run(algorithm, data=None):
    """What an algorithm makes of data; it stays when the algorithm runs again."""
    if data is not None:
        algorithm.SetInputData(data)
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0).NewInstance()
    output.ShallowCopy(algorithm.GetOutputDataObject(0))
    return output


def reduce(image, factor):
    """Each axis divided by factor, each value the mean of its block."""
    shrink = vtkImageShrink3D()
    shrink.SetShrinkFactors(factor, factor, factor)
    shrink.MeanOn()
    small = run(shrink, image)
    small.GetPointData().GetScalars().SetName(image.GetPointData().GetScalars().GetName())
    return small


def add_gradient(data, array):
    """The data with the gradient of a point array, which goes through an extraction as any array."""
    gradient = vtkGradientFilter()
    gradient.SetInputScalars(vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    gradient.SetResultArrayName("Gradient")
    return run(gradient, data)


def make_inflow(field, corners, dimensions, bounds, formula):
    """Where the flow through points of an image came through a plane, by a formula of u and v."""
    plane = vtkTerminationPlane()
    plane.SetOrigin(corners[0])
    plane.SetPoint1(corners[1])
    plane.SetPoint2(corners[2])
    flow = vtkImplicitFlowField()
    flow.AddTerminationSurface(plane)
    flow.SetSampleMode(flow.SAMPLES_OF_IMAGE)
    flow.SetSampleDimensions(*dimensions)
    flow.SetSampleBounds(bounds)
    mapping = vtkInflowMapping()
    mapping.SetFormula(mapping.ALL, formula)
    return run(mapping, run(flow, run(field)))


def make_colors(*points):
    """Colours of values: each point is a value, red, green and blue."""
    colors = vtkColorTransferFunction()
    for point in points:
        colors.AddRGBPoint(*point)
    return colors


def make_opacities(*points):
    """Opacities, or extinctions, of values: each point is a value and what it has."""
    opacities = vtkPiecewiseFunction()
    for point in points:
        opacities.AddPoint(*point)
    return opacities


def make_volume(tetrahedra, array, colors, extinction, of_cells=False):
    mapper = vtkTimeWeightedTetrahedraMapper()
    mapper.SetInputData(tetrahedra)
    if of_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(array)
    mapper.AutoAdjustLevelOfDetailOff()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacity(extinction)
    volume.GetProperty().SetScalarOpacityUnitDistance(1.0)
    return volume


def make_intervals(tetrahedra, *looks):
    """A volume with a pair of colour and extinction for each interval."""
    colors = make_colors(*((i, *color) for i, (color, _) in enumerate(looks)))
    extinction = make_opacities(*((i, value) for i, (_, value) in enumerate(looks)))
    return make_volume(tetrahedra, "IntervalId", colors, extinction, of_cells=True)


def select_triangles(triangles, array, value):
    """The triangles whose cell array has this value, over the points of all."""
    corners = vtk_to_numpy(triangles.GetCells().GetConnectivityArray()).reshape(-1, 3)
    chosen = corners[vtk_to_numpy(triangles.GetCellData().GetArray(array)) == value]
    cells = vtkCellArray()
    offsets = np.arange(0, chosen.size + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtk(offsets, deep=True),
                  numpy_to_vtk(chosen.ravel().astype(np.int64), deep=True))
    selected = vtkUnstructuredGrid()
    selected.SetPoints(triangles.GetPoints())
    selected.GetPointData().ShallowCopy(triangles.GetPointData())
    selected.SetCells(VTK_TRIANGLE, cells)
    return selected


def make_boundary(interval, side):
    """The triangles of one side of the intervals, with normals by the gradient, out of them."""
    chosen = select_triangles(interval.GetOutputDataObject(1), "BoundarySide", side)
    vectors = vtk_to_numpy(chosen.GetPointData().GetArray("Gradient")).astype(float)
    lengths = np.sqrt(dot(vectors, vectors.T))
    normals = vectors * (1.0 / np.where(lengths > 0.0, lengths, 1.0))[:, None]
    if side == vtkIntervalVolume.LOWER_SIDE:
        normals = -normals
    array = numpy_to_vtk(normals.astype(np.float32), deep=True)
    array.SetName("Normals")
    chosen.GetPointData().SetNormals(array)
    return chosen


def set_boundary(volume, triangles, color, opacity):
    """Triangles that are drawn at their place within the volume."""
    volume.GetMapper().SetBoundaryData(triangles)
    look = volume.GetMapper().GetBoundaryProperty()
    look.SetColor(color)
    look.SetOpacity(opacity)
    look.SetAmbient(0.16)
    look.SetDiffuse(0.74)
    look.SetSpecular(0.3)
    look.SetSpecularPower(40.0)


def make_surface(cells, feature_angle=50.0):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(cells)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(feature_angle)
    normals.ConsistencyOff()
    return run(normals)


def make_actor(surface, color):
    actor = vtkActor()
    actor.SetMapper(vtkPolyDataMapper())
    actor.GetMapper().SetInputData(surface)
    actor.GetMapper().ScalarVisibilityOff()
    look = actor.GetProperty()
    look.SetColor(color)
    look.SetAmbient(0.16)
    look.SetDiffuse(0.88)
    look.SetSpecular(0.12)
    look.SetSpecularPower(20.0)
    return actor


def make_sliced_volume(image):
    """An image that casts shadows on itself, with slices half a voxel apart."""
    mapper = vtkShadowedSliceMapper()
    mapper.SetInputData(image)
    mapper.SetSliceSpacing(0.5 * min(image.GetSpacing()))
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetLightBufferSize(768)
    mapper.SetImageSampleDistance(2.0)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(vtkVolumeProperty())
    volume.GetProperty().SetInterpolationTypeToLinear()
    volume.GetProperty().ShadeOn()
    return volume


def make_parallel_light(direction, intensity, color=(1.0, 1.0, 1.0)):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(direction)
    light.SetFocalPoint(0.0, 0.0, 0.0)
    light.SetIntensity(intensity)
    light.SetDiffuseColor(color)
    return light
