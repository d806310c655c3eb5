# SPDX-License-Identifier: BSD-3-Clause
"""Objects of the examples: data, volumes of tetrahedra and of images, surfaces, lights."""

import math
import os
from pathlib import Path

import numpy as np
from interlume import (
    vtkImplicitFlowField, vtkInflowMapping, vtkIntervalVolume, vtkShadowedSliceMapper,
    vtkTerminationPlane, vtkTerminationSurfaceSource, vtkTimeWeightedTetrahedraMapper)
from stage import dot, make_image
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_TRIANGLE, vtkCellArray, vtkDataObject, vtkPiecewiseFunction, vtkPolyData,
    vtkStructuredGrid, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkTexture, vtkVolume,
    vtkVolumeProperty)

DATA = Path(os.environ.get("INTERLUME_DATA") or Path(__file__).parents[2] / "Data")

COLORS = [(0.220, 0.440, 0.720), (0.278, 0.655, 0.580), (0.929, 0.694, 0.263),
          (0.788, 0.286, 0.231), (0.494, 0.341, 0.600), (0.545, 0.565, 0.585)]


def read(name):
    """Reads a file of the directory Data, or of the directory in INTERLUME_DATA."""
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(str(DATA / name))
    reader.Update()
    return reader.GetOutput()


def run(algorithm, data=None):
    """Returns the output of an algorithm, which later runs of the algorithm do not change."""
    if data is not None:
        algorithm.SetInputData(data)
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0).NewInstance()
    output.ShallowCopy(algorithm.GetOutputDataObject(0))
    return output


def reduce(image, factor):
    """Reduces each axis by a factor. Each value is the mean of its block."""
    shrink = vtkImageShrink3D()
    shrink.SetShrinkFactors(factor, factor, factor)
    shrink.MeanOn()
    small = run(shrink, image)
    small.GetPointData().GetScalars().SetName(image.GetPointData().GetScalars().GetName())
    return small


def make_tubes(lines, radius):
    """Returns tubes around the line cells of a dataset."""
    tubes = vtkTubeFilter()
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(12)
    tubes.CappingOn()
    return run(tubes, run(vtkDataSetSurfaceFilter(), lines))


def smooth(image, deviations):
    """Smooths an image by a Gaussian with these standard deviations, in voxels."""
    gaussian = vtkImageGaussianSmooth()
    gaussian.SetStandardDeviations(*deviations)
    gaussian.SetRadiusFactor(2.0)
    return run(gaussian, image)


def add_gradient(data, array):
    """Adds the gradient of a point array, which extractions interpolate like other arrays."""
    gradient = vtkGradientFilter()
    gradient.SetInputScalars(vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    gradient.SetResultArrayName("Gradient")
    result = run(gradient, data)
    # vtkGradientFilter does not pass on the field data of structured datasets.
    result.GetFieldData().PassData(data.GetFieldData())
    return result


def make_plane(center, u, v):
    """Returns a termination plane. u and v are the vectors from its center to its edges."""
    plane = vtkTerminationPlane()
    plane.SetOrigin([c - a - b for c, a, b in zip(center, u, v)])
    plane.SetPoint1([c + a - b for c, a, b in zip(center, u, v)])
    plane.SetPoint2([c - a + b for c, a, b in zip(center, u, v)])
    return plane


def make_inflow(field, plane, samples, formula):
    """Traces samples to a plane and evaluates a formula of u and v there. The samples are a
    dataset, or the dimensions and bounds of an image."""
    flow = vtkImplicitFlowField()
    flow.AddTerminationSurface(plane)
    if isinstance(samples, tuple):
        flow.SetSampleMode(flow.SAMPLES_OF_IMAGE)
        flow.SetSampleDimensions(*samples[0])
        flow.SetSampleBounds(samples[1])
    else:
        flow.SetSampleMode(flow.SAMPLES_OF_INPUT)
        flow.SetSampleData(samples)
    mapping = vtkInflowMapping()
    mapping.SetFormula(mapping.ALL, formula)
    return run(mapping, run(flow, run(field)))


def get_axis(vortex, z):
    """Returns the point on the axis of a tornado at a height."""
    height = z / vortex.GetHeight() + 0.5
    return [tilt * (height - 0.5) + bend * math.sin(math.pi * height)
            for tilt, bend in zip(vortex.GetAxisTilt(), vortex.GetAxisBend())] + [z]


def make_rings(vortex, dimensions, heights, radius):
    """Returns rings of points around the axis of a vortex. radius is a function of a number, 0 for
    the innermost and 1 for the outermost ring, and of the height. Rings start and end along y."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    outward, around, upward = dimensions
    angles = [2.0 * math.pi * (0.25 + j / (around - 1)) for j in range(around)]
    for k in range(upward):
        z = heights[0] + (heights[1] - heights[0]) * k / (upward - 1)
        x, y, _ = get_axis(vortex, z)
        radii = [radius(i / (outward - 1), z) for i in range(outward)]
        for angle in angles:
            for r in radii:
                points.InsertNextPoint(x + r * math.cos(angle), y + r * math.sin(angle), z)
    rings = vtkStructuredGrid()
    rings.SetDimensions(dimensions)
    rings.SetPoints(points)
    return rings


def make_colors(*points):
    """Returns a color function. Each point is a value, red, green and blue."""
    colors = vtkColorTransferFunction()
    for point in points:
        colors.AddRGBPoint(*point)
    return colors


def make_opacities(*points):
    """Returns an opacity or extinction function. Each point is a value and its opacity."""
    opacities = vtkPiecewiseFunction()
    for point in points:
        opacities.AddPoint(*point)
    return opacities


def make_volume(tetrahedra, array, colors, extinction, is_cell_array=False):
    mapper = vtkTimeWeightedTetrahedraMapper()
    mapper.SetInputData(tetrahedra)
    if is_cell_array:
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
    """Returns a volume. Each look is the color and extinction of an interval."""
    colors = make_colors(*((i, *color) for i, (color, _) in enumerate(looks)))
    extinction = make_opacities(*((i, value) for i, (_, value) in enumerate(looks)))
    return make_volume(tetrahedra, "IntervalId", colors, extinction, is_cell_array=True)


def select_triangles(triangles, array, value):
    """Returns the triangles whose cell array has this value, with all points."""
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


def set_gradient_normals(triangles, side):
    """Sets the gradient as outward normals of one side of an interval, and returns the triangles."""
    vectors = vtk_to_numpy(triangles.GetPointData().GetArray("Gradient")).astype(float)
    lengths = np.sqrt(dot(vectors, vectors.T))
    normals = vectors * (1.0 / np.where(lengths > 0.0, lengths, 1.0))[:, None]
    if side == vtkIntervalVolume.LOWER_SIDE:
        normals = -normals
    array = numpy_to_vtk(normals.astype(np.float32), deep=True)
    array.SetName("Normals")
    triangles.GetPointData().SetNormals(array)
    return triangles


def make_boundary(interval, side):
    """Returns the boundary triangles of one side, with outward normals from the gradient."""
    return set_gradient_normals(
        select_triangles(interval.GetOutputDataObject(1), "BoundarySide", side), side)


def set_boundary(volume, triangles, color, opacity):
    """Draws triangles inside the volume."""
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


def shade_by_field(surface, evaluate):
    """Returns the triangles of a level surface near the zeros of evaluate(x), with the normals of the
    field. Sides along x and y, where the surface is cut off, keep their own normals."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    bounds = np.reshape(surface.GetBounds(), (3, 2))
    values = np.array([evaluate(point) for point in points])
    steps = np.where(values > 0.0, 1e-4, -1e-4)
    normals = np.stack([
        [evaluate(point + step * axis) for point, step in zip(points, steps)] - values
        for axis in np.eye(3)], axis=1)
    normals = (normals / np.linalg.norm(normals, axis=1)[:, None])[ids].reshape(-1, 3, 3)
    corners = points[ids].reshape(-1, 3, 3)
    for side in (3, 2, 1, 0):
        axis, end = divmod(side, 2)
        flat = np.all(np.abs(corners[:, :, axis] - bounds[axis, end]) < 1e-4, axis=1)
        normals[flat] = (2.0 * end - 1.0) * np.eye(3)[axis]
    shaded = vtkPolyData()
    shaded.SetPoints(vtkPoints())
    shaded.GetPoints().SetData(numpy_to_vtk(corners.reshape(-1, 3).astype(np.float32), deep=True))
    shaded.SetPolys(vtkCellArray())
    shaded.GetPolys().SetData(3, numpy_to_vtk(np.arange(len(ids), dtype=np.int64), deep=True))
    array = numpy_to_vtk(normals.reshape(-1, 3).astype(np.float32), deep=True)
    array.SetName("Normals")
    shaded.GetPointData().SetNormals(array)
    return shaded


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


def make_painted_actor(plane, value, lower, upper, color, ground):
    """Returns an actor of a termination plane. It has a color where the value at (u, v) is between
    the bounds, and the color of the ground elsewhere."""
    u, v = np.meshgrid(np.linspace(0.0, 1.0, 512), np.linspace(0.0, 1.0, 512))
    values = value(u, v)
    inside = (values > lower) & (values < upper)
    pixels = np.where(inside[..., None], np.float32(color).astype(float), ground) * 255.0
    texture = vtkTexture()
    texture.SetInputData(make_image(pixels.astype(np.uint8)))
    texture.InterpolateOn()
    source = vtkTerminationSurfaceSource()
    source.SetSurface(plane)
    source.SetResolutionU(128)
    source.SetResolutionV(128)
    actor = make_actor(run(source), (1.0, 1.0, 1.0))
    actor.SetTexture(texture)
    return actor


def make_smooth_surface(flow_volume, number, color):
    """Returns an actor of a stream surface, with normals from the gradient."""
    triangles = select_triangles(
        flow_volume.GetOutputDataObject(1), "StreamSurfaceId", number)
    set_gradient_normals(triangles, vtkIntervalVolume.LOWER_SIDE)
    return make_actor(run(vtkDataSetSurfaceFilter(), triangles), color)


def make_sliced_volume(image):
    """Returns a volume with self-shadowing and a slice spacing of half a voxel."""
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
