# SPDX-License-Identifier: BSD-3-Clause
"""A sphere of smoke above a floor under an area light, with mutual shadows."""

from guide_image import GuideImage
from interlume import vtkAreaLight, vtkShadowedScenePass, vtkShadowedSliceMapper, vtkTurbulenceSource
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkVolume

picture = GuideImage()

smoke = vtkTurbulenceSource()
smoke.SetEnvelope(vtkTurbulenceSource.SPHERE)
mapper = vtkShadowedSliceMapper()
mapper.SetInputConnection(smoke.GetOutputPort())
gray = vtkColorTransferFunction()
gray.AddRGBPoint(0.0, 0.9, 0.9, 0.9)
opacities = vtkPiecewiseFunction()
opacities.AddPoint(0.0, 0.0)
opacities.AddPoint(1.0, 0.9)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(gray)
volume.GetProperty().SetScalarOpacity(opacities)
volume.GetProperty().SetScalarOpacityUnitDistance(0.1)
picture.renderer.AddVolume(volume)
floor = vtkPlaneSource()
floor.SetOrigin(-2.0, -2.0, -1.1)
floor.SetPoint1(2.0, -2.0, -1.1)
floor.SetPoint2(-2.0, 2.0, -1.1)
surface = vtkPolyDataMapper()
surface.SetInputConnection(floor.GetOutputPort())
actor = vtkActor()
actor.SetMapper(surface)
picture.renderer.AddActor(actor)
lamp = vtkAreaLight()
lamp.SetPosition(-2.0, 0.0, 2.5)
lamp.SetSize(0.8, 0.8)
picture.renderer.AddLight(lamp)
shadows = vtkShadowedScenePass()
picture.renderer.SetPass(shadows)

picture.write(0.4, -1.5, 0.8)
