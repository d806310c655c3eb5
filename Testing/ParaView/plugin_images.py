# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by tests of the plugin's representations: views and colors as in C++, small datasets, pixels."""

import os

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkIOImage import vtkPNGReader

from plugin_testing import extractions_path

SMALLEST_CHANGE = 0.5  # mean difference of images with different settings, in steps of 1/255
SMALLEST_FRACTION = 0.15  # fraction of pixels that differ from the background


def make_view(picture):
    view = simple.CreateView("RenderView")
    view.ViewSize = picture["size"]
    view.UseColorPaletteForBackground = False
    view.Background = picture["background"]
    view.OrientationAxesVisibility = False
    view.CameraPosition = picture["camera"]["position"]
    view.CameraFocalPoint = picture["camera"]["focus"]
    view.CameraViewUp = picture["camera"]["up"]
    view.CameraViewAngle = picture["camera"]["angle"]
    return view


def load_texture(path):
    """Loads an image file as a texture. ParaView 5.13 reads it when the proxy is updated."""
    texture = simple.CreateTexture(path)
    texture.UpdateVTKObjects()
    return texture


def set_light(light, values):
    light.Coords = "Scene"
    light.Position = values["position"]
    light.FocalPoint = values["focus"]
    light.DiffuseColor = values["color"]
    light.Intensity = values["intensity"]


def set_colors(display, view, color_by, picture):
    """Sets the array for coloring and its transfer functions."""
    simple.ColorBy(display, color_by, separate=True)
    display.SetScalarBarVisibility(view, False)
    colors = display.LookupTable
    colors.RGBPoints = [number for row in picture["colors"] for number in row]
    colors.ColorSpace = "RGB"
    opacities = display.ScalarOpacityFunction
    opacities.Points = [number for row in picture["opacities"] for number in (*row, 0.5, 0.0)]


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return values[:, :3].astype(int)


class Comparison:
    """Compares images, each with different settings, with the images of C++."""

    def __init__(self, checks):
        self.checks = checks
        self.seen = {}

    def compare(self, name, path, bounds):
        """`bounds` are the largest and the mean difference in steps of 1/255."""
        largest, mean = bounds
        drawn, expected = pixels(path), pixels(extractions_path(name + ".png"))
        difference = numpy.abs(drawn - expected)
        shown = numpy.mean((drawn != drawn[0]).any(axis=1))
        print(f"{name}: largest {difference.max()}, mean {difference.mean():.5f}, shown {shown:.3f}")
        self.checks.that(difference.max() <= largest, f"{name}, largest difference")
        self.checks.that(difference.mean() <= mean, f"{name}, mean difference")
        self.checks.that(shown >= SMALLEST_FRACTION, f"{name} is visible")
        for other, shot in self.seen.items():
            if shot.shape != drawn.shape:
                continue
            change = numpy.abs(drawn - shot).mean()
            self.checks.that(change >= SMALLEST_CHANGE, f"{name} differs from {other}: {change}")
        self.seen[name] = drawn


BACKGROUND = (0, 0, 0)
VIEW_SIZE = [300, 300]


def plain_view():
    """Returns a small view with a black background and without axes."""
    view = simple.CreateView("RenderView")
    view.ViewSize = VIEW_SIZE
    view.UseColorPaletteForBackground = False
    view.Background = BACKGROUND
    view.OrientationAxesVisibility = False
    return view


def look_at(view):
    """Looks at all data from an oblique direction."""
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Azimuth(25)
    camera.Elevation(20)
    simple.ResetCamera(view)


def snapshot(view):
    """Renders a view and returns its pixels: rows of red, green and blue from 0 to 255."""
    simple.Render(view)
    image = view.SMProxy.CaptureWindow(1)
    return vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].astype(int)


def fraction_shown(shot):
    """Returns the fraction of the image that is not background."""
    return numpy.mean((shot != BACKGROUND).any(axis=1))


def color_by(display, array):
    """Colors by an array, or the solid color if it is None, which ParaView does not accept twice."""
    if array or display.ColorArrayName.GetArrayName():
        simple.ColorBy(display, array)


def producer(data):
    """Returns a source of the dataset itself, without a copy, in this process."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def add_array(data, name, values, of_points=True):
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    (data.GetPointData() if of_points else data.GetCellData()).AddArray(array)


def image(side=9, origin=(0.0, 0.0, 0.0)):
    """Returns a cube of samples without arrays."""
    data = vtkImageData()
    data.SetDimensions(side, side, side)
    data.SetOrigin(origin)
    return data


def grid(side=5, origin=(0.0, 0.0, 0.0)):
    """Returns a cube of tetrahedra without arrays."""
    tetrahedra = vtkDataSetTriangleFilter()
    tetrahedra.SetInputData(image(side, origin))
    tetrahedra.Update()
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(tetrahedra.GetOutput())
    return copy


def coordinates(data):
    """Returns the point coordinates."""
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def image_path(folder, test, name):
    return os.path.join(folder, f"{test}-{name}.png")
