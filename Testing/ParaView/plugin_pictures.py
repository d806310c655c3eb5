# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin's representations share: views and colours as C++ had them, small data,
pixels."""

import os

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkIOImage import vtkPNGReader

from plugin_testing import extractions_path

SMALLEST_CHANGE = 0.5  # mean difference of pictures drawn in other ways, in steps of 1/255
SMALLEST_SHARE = 0.15  # of the picture that shows something


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
    """An image file as a texture. ParaView 5.13 reads it once the proxy is told to update."""
    made = simple.CreateTexture(path)
    made.UpdateVTKObjects()
    return made


def set_light(light, values):
    light.Coords = "Scene"
    light.Position = values["position"]
    light.FocalPoint = values["focus"]
    light.DiffuseColor = values["color"]
    light.Intensity = values["intensity"]


def set_colors(display, view, color_by, picture):
    """The array to colour by and its functions."""
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
    """Compares pictures, each drawn in another way, with those of C++."""

    def __init__(self, checks):
        self.checks = checks
        self.seen = {}

    def compare(self, name, path, bounds):
        """`bounds`: the largest and the mean difference in steps of 1/255."""
        largest, mean = bounds
        drawn, expected = pixels(path), pixels(extractions_path(name + ".png"))
        difference = numpy.abs(drawn - expected)
        shown = numpy.mean((drawn != drawn[0]).any(axis=1))
        print(f"{name}: largest {difference.max()}, mean {difference.mean():.5f}, shown {shown:.3f}")
        self.checks.that(difference.max() <= largest, f"{name}, every pixel")
        self.checks.that(difference.mean() <= mean, f"{name}, the mean")
        self.checks.that(shown >= SMALLEST_SHARE, f"{name} shows something")
        for other, shot in self.seen.items():
            if shot.shape != drawn.shape:
                continue
            change = numpy.abs(drawn - shot).mean()
            self.checks.that(change >= SMALLEST_CHANGE, f"{name} differs from {other}: {change}")
        self.seen[name] = drawn


BACKGROUND = (0, 0, 0)
VIEW_SIZE = [300, 300]


def plain_view():
    """A small view with nothing but the data before black."""
    view = simple.CreateView("RenderView")
    view.ViewSize = VIEW_SIZE
    view.UseColorPaletteForBackground = False
    view.Background = BACKGROUND
    view.OrientationAxesVisibility = False
    return view


def look_at(view):
    """All that is shown, from the side."""
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Azimuth(25)
    camera.Elevation(20)
    simple.ResetCamera(view)


def snapshot(view):
    """The pixels of a view, rendered anew: rows of red, green and blue, 0 to 255."""
    simple.Render(view)
    image = view.SMProxy.CaptureWindow(1)
    return vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].astype(int)


def share_shown(shot):
    """The share of the picture that is not background."""
    return numpy.mean((shot != BACKGROUND).any(axis=1))


def color_by(display, array):
    """By an array, or None: the solid colour, which ParaView refuses to set where it is set."""
    if array or display.ColorArrayName.GetArrayName():
        simple.ColorBy(display, array)


def producer(data):
    """A source of the very dataset, in this process."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def add_array(data, name, values, of_points=True):
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    (data.GetPointData() if of_points else data.GetCellData()).AddArray(array)


def image(side=9, origin=(0.0, 0.0, 0.0)):
    """A cube of samples without arrays."""
    data = vtkImageData()
    data.SetDimensions(side, side, side)
    data.SetOrigin(origin)
    return data


def grid(side=5, origin=(0.0, 0.0, 0.0)):
    """A cube of tetrahedra without arrays."""
    tetrahedra = vtkDataSetTriangleFilter()
    tetrahedra.SetInputData(image(side, origin))
    tetrahedra.Update()
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(tetrahedra.GetOutput())
    return copy


def coordinates(data):
    """Those of the points."""
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def picture_path(folder, test, name):
    return os.path.join(folder, f"{test}-{name}.png")
