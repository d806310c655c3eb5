# SPDX-License-Identifier: BSD-3-Clause
"""Vortex tubes at three time steps and between them: blue tubes fade, red ones appear, white ones persist."""

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingVolumeOpenGL2
from interlume import (
    vtkAnalyticFieldSource, vtkTemporalColorTransferFunction, vtkTimeVaryingIntervalVolume,
    vtkTimeWeightedTetrahedraMapper)
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume

vortices = vtkAnalyticFieldSource()
vortices.SetFieldToVortex()
vortices.SetDimensions(96, 96, 96)
vortices.SetTimeRange(0, 2)
vortices.SetNumberOfTimeSteps(3)
swept = vtkTimeVaryingIntervalVolume()
swept.SetInputConnection(vortices.GetOutputPort())
swept.SetInterval(0, 0.5, 2)
colors = vtkTemporalColorTransferFunction()
colors.SetTimes(3, [0, 1, 2])
extinction = vtkPiecewiseFunction()
extinction.AddPoint(0, 14)
mapper = vtkTimeWeightedTetrahedraMapper()
mapper.SetInputConnection(swept.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray("Time")
mapper.SetBlendModeToAdditive()
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(extinction)

renderer = vtkRenderer()
renderer.AddVolume(volume)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.3, 1, 0.4)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.75)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Temporal colors")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
