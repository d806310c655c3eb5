# SPDX-License-Identifier: BSD-3-Clause
"""Hot gas around a spinning disk, as a volume of tetrahedra."""

import sys

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingVolumeOpenGL2
from interlume import vtkIntervalVolume, vtkTimeWeightedTetrahedraMapper
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPiecewiseFunction
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume)

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "../../Data/disk_out_ref.vtu")
gas = vtkIntervalVolume()
gas.SetInputConnection(reader.GetOutputPort())
gas.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Temp")
gas.SetInterval(0, 400, 950)
mapper = vtkTimeWeightedTetrahedraMapper()
mapper.SetInputConnection(gas.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray("Temp")
colors = vtkColorTransferFunction()
colors.AddRGBPoint(400, 0.15, 0.35, 0.80)
colors.AddRGBPoint(550, 0.30, 0.75, 0.75)
colors.AddRGBPoint(700, 1.00, 0.80, 0.30)
colors.AddRGBPoint(880, 1.00, 0.30, 0.10)
extinction = vtkPiecewiseFunction()
extinction.AddPoint(400, 0.10)
extinction.AddPoint(550, 0.15)
extinction.AddPoint(700, 0.60)
extinction.AddPoint(880, 4.00)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(extinction)

renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.SetBackground(0.06, 0.07, 0.10)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.4, -1, 0.6)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.4)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Tetrahedra")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
