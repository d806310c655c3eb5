# SPDX-License-Identifier: BSD-3-Clause
"""Disks painted on the inflow, advected through the flow around a sphere. A new image needs no new advection."""

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingVolumeOpenGL2
from interlume import (
    vtkAnalyticFlowSource, vtkImplicitFlowField, vtkImplicitFlowVolumeMapper, vtkTerminationPlane)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume)

flow = vtkAnalyticFlowSource()
flow.SetField(vtkAnalyticFlowSource.SPHERE)
flow.SetBounds(-1.5, 1.5, -1, 1, -1, 1)
flow.SetDimensions(97, 65, 65)
flow.SetRadius(0.4)
inflow = vtkTerminationPlane()
inflow.SetOrigin(-1.5, -0.7, -0.7)
inflow.SetPoint1(-1.5, 0.7, -0.7)
inflow.SetPoint2(-1.5, -0.7, 0.7)
field = vtkImplicitFlowField()
field.SetInputConnection(flow.GetOutputPort())
field.AddTerminationSurface(inflow)
field.SetSampleMode(vtkImplicitFlowField.SAMPLES_OF_IMAGE)
field.SetSampleDimensions(121, 81, 81)
paint = vtkImageCanvasSource2D()
paint.SetScalarTypeToUnsignedChar()
paint.SetNumberOfScalarComponents(4)
paint.SetExtent(0, 255, 0, 255, 0, 0)
paint.SetDrawColor(0, 0, 0, 0)
paint.FillBox(0, 255, 0, 255)
for y in (32, 80, 128, 176, 224):
    for x in (32, 80, 128, 176, 224):
        paint.SetDrawColor(20 + x, 110, 260 - y, 240)
        paint.FillBox(x - 8, x + 8, y - 8, y + 8)
paint.Update()
mapper = vtkImplicitFlowVolumeMapper()
mapper.SetInputConnection(field.GetOutputPort())
mapper.SetInflowTexture(inflow.GetId(), paint.GetOutput())
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetScalarOpacityUnitDistance(0.05)
sphere = vtkSphereSource()
sphere.SetRadius(0.4)
sphere.SetThetaResolution(64)
sphere.SetPhiResolution(64)
surface = vtkPolyDataMapper()
surface.SetInputConnection(sphere.GetOutputPort())
ball = vtkActor()
ball.SetMapper(surface)
ball.GetProperty().SetColor(0.85, 0.85, 0.85)

renderer = vtkRenderer()
renderer.AddActor(ball)
renderer.AddVolume(volume)
renderer.SetBackground(0.94, 0.94, 0.93)
camera = renderer.GetActiveCamera()
camera.SetPosition(-0.7, -1, 0.55)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.75)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Paint")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
