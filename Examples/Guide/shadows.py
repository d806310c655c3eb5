# SPDX-License-Identifier: BSD-3-Clause
"""A scanned bonsai that casts shadows on itself."""

import sys

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingVolumeOpenGL2
from interlume import vtkShadowedSliceMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume)

reader = vtkXMLImageDataReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "../../Data/bonsai.vti")
tree = vtkExtractVOI()
tree.SetInputConnection(reader.GetOutputPort())
tree.SetVOI(30, 226, 10, 236, 62, 255)
mapper = vtkShadowedSliceMapper()
mapper.SetInputConnection(tree.GetOutputPort())
colors = vtkColorTransferFunction()
colors.AddRGBPoint(40, 0.30, 0.52, 0.16)
colors.AddRGBPoint(65, 0.52, 0.68, 0.26)
colors.AddRGBPoint(85, 0.55, 0.40, 0.24)
colors.AddRGBPoint(170, 0.55, 0.36, 0.22)
colors.AddRGBPoint(200, 0.80, 0.45, 0.30)
opacities = vtkPiecewiseFunction()
opacities.AddPoint(34, 0)
opacities.AddPoint(60, 0.5)
opacities.AddPoint(130, 0.9)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(opacities)
volume.GetProperty().ShadeOn()
sun = vtkLight()
sun.SetPosition(-1.0, 1.4, 0.4)
sun.SetIntensity(2.4)
sky = vtkLight()
sky.SetPosition(0.6, 0.5, -1.0)
sky.SetIntensity(0.5)
sky.SetShadowAttenuation(0)

renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.AddLight(sun)
renderer.AddLight(sky)
renderer.SetBackground(0.92, 0.92, 0.90)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.2, 0.3, -1)
camera.SetViewUp(0, 1, 0)
renderer.ResetCamera()
camera.Zoom(1.5)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Shadows")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
