# SPDX-License-Identifier: BSD-3-Clause
"""A scanned tooth with full multiple scattering."""

from guide_image import GuideImage
from interlume import vtkShadowedSliceMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkLight, vtkVolume

picture = GuideImage()

reader = vtkXMLImageDataReader()
reader.SetFileName(picture.path("tooth.vti"))
albedo = vtkColorTransferFunction()
albedo.AddRGBPoint(0.0, 0.999, 0.995, 0.975)
mapper = vtkShadowedSliceMapper()
mapper.SetInputConnection(reader.GetOutputPort())
mapper.SetScatteringModeToFull()
mapper.SetPhaseFunctionToHenyeyGreenstein()
mapper.SetAnisotropy(0.8)
mapper.SetScatteringAlbedo(albedo)
opacities = vtkPiecewiseFunction()
opacities.AddPoint(115.0, 0.0)
opacities.AddPoint(150.0, 0.4)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(albedo)
volume.GetProperty().SetScalarOpacity(opacities)
picture.renderer.AddVolume(volume)
sun = vtkLight()
sun.SetPosition(1.0, 0.6, 0.5)
sun.SetIntensity(0.6)
picture.renderer.AddLight(sun)

picture.write(0.3, -1.5, 0.4)
