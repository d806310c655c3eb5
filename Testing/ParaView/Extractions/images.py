# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by the programs that render images for ParaView to reproduce from descriptions."""

import json
import os

import numpy
import vtkmodules.vtkRenderingOpenGL2  # pylint: disable=unused-import
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)

from pipelines import connected, set_properties, updated


def gyroid_camera(angle):
    return {"position": [2.8, -1.25, 1.0], "focus": [0.0, 0.0, -0.06], "up": [0.0, 0.0, 1.0], "angle": angle}


def make_volume(mapper, picture):
    """Returns a volume with the transfer functions of a case, if it has any. `colors` are rows of value, red,
    green, blue, `opacities` rows of value, opacity, and `unit` is the unit distance of the opacity."""
    volume = vtkVolume()
    volume.SetMapper(mapper)
    if "colors" in picture:
        colors, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
        for row in picture["colors"]:
            colors.AddRGBPoint(*row)
        for row in picture["opacities"]:
            opacities.AddPoint(*row)
        volume.GetProperty().SetColor(colors)
        volume.GetProperty().SetScalarOpacity(opacities)
    volume.GetProperty().SetScalarOpacityUnitDistance(picture["unit"])
    return volume


def set_light(light, values):
    """Makes a scene light from `position`, `focus`, `color` and `intensity`."""
    light.SetLightTypeToSceneLight()
    return set_properties(light, {
        "Position": values["position"], "FocalPoint": values["focus"], "Color": values["color"],
        "Intensity": values["intensity"]})


def make_renderer(volume, lights=None):
    """Returns a renderer with the given lights, or with a headlight if they are None."""
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    if lights is not None:
        renderer.AutomaticLightCreationOff()
        for light in lights:
            renderer.AddLight(light)
    return renderer


def crop(mapper, bounds, scale):
    """Crops to the bounds, scaled about the origin."""
    mapper.CroppingOn()
    mapper.SetCroppingRegionFlagsToSubVolume()
    mapper.SetCroppingRegionPlanes([scale[i // 2] * bounds[i] for i in range(6)])


def write_png(filter_or_image, path):
    writer = vtkPNGWriter()
    if isinstance(filter_or_image, vtkImageData):
        writer.SetInputData(filter_or_image)
    else:
        connected(writer, filter_or_image)
    writer.SetFileName(path)
    writer.Write()
    assert writer.GetErrorCode() == 0, f"cannot write {path}"


def write_image(path, color):
    """Writes an image of 64 by 64 pixels. `color` is a function of the pixel coordinates x and y."""
    y, x = numpy.mgrid[0:64, 0:64]
    values = numpy.stack(numpy.broadcast_arrays(*color(x, y)), axis=-1).astype(numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(64, 64, 1)
    scalars = numpy_to_vtk(values.reshape(64 * 64, -1), deep=True)
    scalars.SetName("ImageScalars")
    image.GetPointData().SetScalars(scalars)
    write_png(image, path)


def read_image(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    return updated(reader).GetOutput()


def save_image(renderer, picture, folder):
    """Renders with the case's `background`, `camera` and `size` and writes `<name>.png`."""
    renderer.SetBackground(picture["background"])
    camera = picture["camera"]
    set_properties(renderer.GetActiveCamera(), {
        "Position": camera["position"], "FocalPoint": camera["focus"], "ViewUp": camera["up"],
        "ViewAngle": camera["angle"]})
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(picture["size"])
    window.AddRenderer(renderer)
    window.Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    write_png(grabber, os.path.join(folder, picture["name"] + ".png"))


def write_images(folder, list_name, cases, draw):
    """Renders each case, then writes the list of cases to a file."""
    # A virtual X server restarts when its last client exits, so keep one window open.
    display = vtkRenderWindow()
    display.OffScreenRenderingOn()
    display.SetSize(8, 8)
    display.Render()
    for picture in cases:
        save_image(draw(picture, folder), picture, folder)
    with open(os.path.join(folder, list_name), "w", encoding="utf-8") as file:
        json.dump(cases, file, indent=2)
