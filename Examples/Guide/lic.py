# SPDX-License-Identifier: BSD-3-Clause
"""Streaks of line integral convolution on a slice of the flow past a post."""

import sys

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
from interlume import vtkFlowLIC
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLStructuredGridReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor)

reader = vtkXMLStructuredGridReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "../../Data/post.vts")
plane = vtkPlaneSource()
plane.SetOrigin(-2.4, -2, 1.5)
plane.SetPoint1(3.6, -2, 1.5)
plane.SetPoint2(-2.4, 2, 1.5)
plane.SetResolution(300, 200)
lic = vtkFlowLIC()
lic.SetInputConnection(plane.GetOutputPort())
lic.SetFieldConnection(reader.GetOutputPort())
lic.SetNoiseScale(0.07)
lic.SetLength(0.5)
lic.SetContrast(0.25)
colors = vtkColorTransferFunction()
colors.AddRGBPoint(0, 0.02, 0.10, 0.25)
colors.AddRGBPoint(0.5, 0.20, 0.55, 0.75)
colors.AddRGBPoint(1, 1.0, 0.98, 0.90)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(lic.GetOutputPort())
mapper.SetLookupTable(colors)
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().LightingOff()

renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(0.06, 0.07, 0.09)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -0.4, 1)
camera.SetViewUp(0, 1, 0)
renderer.ResetCamera()
camera.Zoom(1.75)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("LIC")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
