# SPDX-License-Identifier: BSD-3-Clause
"""A stream volume around a hot disk: its streamlines start between two values of an inflow mapping."""

from guide_image import GuideImage
from interlume import (
    vtkFlowVolume, vtkImplicitFlowField, vtkInflowMapping, vtkTerminationPlane, vtkTimeWeightedTetrahedraMapper)
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPiecewiseFunction
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume

picture = GuideImage()

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(picture.path("disk_out_ref.vtu"))
inflow = vtkTerminationPlane()
inflow.SetOrigin(-5.0, -5.0, 10.0)
inflow.SetPoint1(5.0, -5.0, 10.0)
inflow.SetPoint2(-5.0, 5.0, 10.0)
field = vtkImplicitFlowField()
field.SetInputConnection(reader.GetOutputPort())
field.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "V")
field.AddTerminationSurface(inflow)
mapping = vtkInflowMapping()
mapping.SetInputConnection(field.GetOutputPort())
mapping.SetFormula(vtkInflowMapping.ALL, "sqrt((u - 0.5)^2 + (v - 0.5)^2)")
stream = vtkFlowVolume()
stream.SetInputConnection(mapping.GetOutputPort())
stream.SetInterval(0, 0.05, 0.2)
mapper = vtkTimeWeightedTetrahedraMapper()
mapper.SetInputConnection(stream.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray("Temp")
colors = vtkColorTransferFunction()
colors.AddRGBPoint(300.0, 0.22, 0.44, 0.72)
colors.AddRGBPoint(900.0, 0.79, 0.29, 0.23)
extinction = vtkPiecewiseFunction()
extinction.AddPoint(300.0, 1.0)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(extinction)
picture.renderer.AddVolume(volume)

picture.write(1.0, -1.5, 0.7)
