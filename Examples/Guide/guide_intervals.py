# SPDX-License-Identifier: BSD-3-Clause
"""The region between two values of an electron density, as the surface of its tetrahedra."""

from guide_image import GuideImage
from interlume import vtkIntervalVolume
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper

picture = GuideImage()

reader = vtkXMLImageDataReader()
reader.SetFileName(picture.path("hydrogen_orbital.vti"))
region = vtkIntervalVolume()
region.SetInputConnection(reader.GetOutputPort())
region.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "probability_density")
region.SetInterval(0, 0.06, 0.4)
mapper = vtkDataSetMapper()
mapper.SetInputConnection(region.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.28, 0.65, 0.58)
picture.renderer.AddActor(actor)

picture.write(1.0, -1.5, 0.7)
