# SPDX-License-Identifier: BSD-3-Clause
"""Gas that flows onto a hot disk: two nested stream volumes, colored by the time since the gas entered, cut in half."""

import sys

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
from interlume import vtkFlowVolume, vtkImplicitFlowField, vtkInflowMapping, vtkTerminationPlane
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
    vtkRenderWindowInteractor)

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "../../Data/disk_out_ref.vtu")
inlet = vtkTerminationPlane()
inlet.SetOrigin(-5.75, -5.75, 10)
inlet.SetPoint1(5.75, -5.75, 10)
inlet.SetPoint2(-5.75, 5.75, 10)
field = vtkImplicitFlowField()
field.SetInputConnection(reader.GetOutputPort())
field.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "V")
field.AddTerminationSurface(inlet)
field.SetSampleMode(vtkImplicitFlowField.SAMPLES_OF_IMAGE)
field.SetSampleDimensions(65, 33, 65)
field.SetSampleBounds(-5.7, 5.7, 0, 5.7, 0.1, 10)
field.SetMaximumTime(20)
radius = vtkInflowMapping()
radius.SetInputConnection(field.GetOutputPort())
radius.SetFormula(vtkInflowMapping.ALL, "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)")
stream = vtkFlowVolume()
stream.SetInputConnection(radius.GetOutputPort())
stream.SetInterval(0, 0.3, 0.42)
stream.SetInterval(1, 0.6, 0.72)
stream.SetTimeRange(0, 5.5)
surface = vtkDataSetSurfaceFilter()
surface.SetInputConnection(stream.GetOutputPort())
normals = vtkPolyDataNormals()
normals.SetInputConnection(surface.GetOutputPort())
normals.SetFeatureAngle(45)
colors = vtkColorTransferFunction()
colors.AddRGBPoint(0, 0.18, 0.35, 0.75)
colors.AddRGBPoint(0.7, 0.35, 0.70, 0.75)
colors.AddRGBPoint(1.4, 0.95, 0.75, 0.35)
colors.AddRGBPoint(2.2, 0.85, 0.30, 0.20)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(normals.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectColorArray("AdvectionTime")
mapper.SetLookupTable(colors)
actor = vtkActor()
actor.SetMapper(mapper)

renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(0.93, 0.93, 0.92)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.3, -1, 0.3)
camera.SetViewUp(1, 0, 0)
renderer.ResetCamera()
camera.Zoom(1.3)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Flow")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
