# SPDX-License-Identifier: BSD-3-Clause
"""Hot gas around a spinning disk as a volume of tetrahedra whose extinction depends on temperature."""

from guide_image import GuideImage
from interlume import vtkIntervalVolume, vtkTimeWeightedTetrahedraMapper
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPiecewiseFunction
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume

picture = GuideImage()

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(picture.path("disk_out_ref.vtu"))
gas = vtkIntervalVolume()
gas.SetInputConnection(reader.GetOutputPort())
gas.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Temp")
gas.SetInterval(0, 400.0, 900.0)
mapper = vtkTimeWeightedTetrahedraMapper()
mapper.SetInputConnection(gas.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray("Temp")
colors = vtkColorTransferFunction()
colors.AddRGBPoint(400.0, 0.22, 0.44, 0.72)
colors.AddRGBPoint(650.0, 0.93, 0.69, 0.26)
colors.AddRGBPoint(900.0, 0.79, 0.29, 0.23)
extinction = vtkPiecewiseFunction()
extinction.AddPoint(400.0, 0.1)
extinction.AddPoint(900.0, 1.5)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(extinction)
picture.renderer.AddVolume(volume)

picture.write(1.0, -1.5, 0.7)
