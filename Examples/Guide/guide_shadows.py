# SPDX-License-Identifier: BSD-3-Clause
"""The electron density in a hydrogen atom: its lobes cast shadows on the ring around it."""

from guide_image import GuideImage
from interlume import vtkShadowedSliceMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkLight, vtkVolume

picture = GuideImage()

reader = vtkXMLImageDataReader()
reader.SetFileName(picture.path("hydrogen_orbital.vti"))
mapper = vtkShadowedSliceMapper()
mapper.SetInputConnection(reader.GetOutputPort())
colors = vtkColorTransferFunction()
colors.AddRGBPoint(0.05, 0.28, 0.65, 0.58)
colors.AddRGBPoint(0.5, 0.93, 0.69, 0.26)
opacities = vtkPiecewiseFunction()
opacities.AddPoint(0.05, 0.0)
opacities.AddPoint(0.08, 0.9)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(opacities)
volume.GetProperty().ShadeOn()
picture.renderer.AddVolume(volume)
sun = vtkLight()
sun.SetPosition(0.8, -0.5, 1.2)
sun.SetIntensity(1.6)
picture.renderer.AddLight(sun)

picture.write(1.0, -1.5, 0.7)
