# SPDX-License-Identifier: BSD-3-Clause
"""Vortex tubes over all times between two steps: blue at the first, red at the second."""

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingVolumeOpenGL2
from interlume import vtkAnalyticFieldSource, vtkTimeVaryingIntervalVolume, vtkTimeWeightedTetrahedraMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume)

vortices = vtkAnalyticFieldSource()
vortices.SetFieldToVortex()
vortices.SetDimensions(96, 96, 96)
vortices.SetTimeRange(1.2, 2.0)
vortices.SetNumberOfTimeSteps(2)
swept = vtkTimeVaryingIntervalVolume()
swept.SetInputConnection(vortices.GetOutputPort())
swept.SetInterval(0, 0.5, 2)
mapper = vtkTimeWeightedTetrahedraMapper()
mapper.SetInputConnection(swept.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray("Time")
colors = vtkColorTransferFunction()
colors.AddRGBPoint(1.2, 0.10, 0.35, 0.95)
colors.AddRGBPoint(1.6, 0.75, 0.60, 0.65)
colors.AddRGBPoint(2.0, 0.95, 0.25, 0.10)
extinction = vtkPiecewiseFunction()
extinction.AddPoint(1.2, 60)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(extinction)

renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.SetBackground(0.04, 0.05, 0.07)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.3, -1, 0.25)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.75)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Time")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
