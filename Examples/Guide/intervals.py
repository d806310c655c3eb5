# SPDX-License-Identifier: BSD-3-Clause
"""A scanned tooth cut in half: pulp, dentine and enamel as adjacent intervals of its density, in one mesh."""

import sys

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
from interlume import vtkIntervalVolume
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor)

reader = vtkXMLImageDataReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "../../Data/tooth.vti")
smooth = vtkImageGaussianSmooth()
smooth.SetInputConnection(reader.GetOutputPort())
smooth.SetStandardDeviation(1.0)
half = vtkExtractVOI()
half.SetInputConnection(smooth.GetOutputPort())
half.SetVOI(0, 102, 44, 93, 0, 160)
tissues = vtkIntervalVolume()
tissues.SetInputConnection(half.GetOutputPort())
tissues.SetInterval(0, 105, 150)
tissues.SetInterval(1, 150, 205)
tissues.SetInterval(2, 205, 255)
surface = vtkDataSetSurfaceFilter()
surface.SetInputConnection(tissues.GetOutputPort())
normals = vtkPolyDataNormals()
normals.SetInputConnection(surface.GetOutputPort())
normals.SetFeatureAngle(45)
colors = vtkLookupTable()
colors.SetNumberOfTableValues(3)
colors.SetTableValue(0, 0.79, 0.29, 0.23)
colors.SetTableValue(1, 0.93, 0.69, 0.26)
colors.SetTableValue(2, 0.95, 0.94, 0.90)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(normals.GetOutputPort())
mapper.SetScalarModeToUseCellFieldData()
mapper.SelectColorArray("IntervalId")
mapper.SetLookupTable(colors)
mapper.SetScalarRange(0, 2)
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetSpecular(0.3)
actor.GetProperty().SetSpecularPower(30)

renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(0.13, 0.15, 0.19)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.3, -1, 0.3)
camera.SetViewUp(1, 0, 0.2)
renderer.ResetCamera()
camera.Zoom(1.7)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Intervals")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
