# SPDX-License-Identifier: BSD-3-Clause
"""A sphere with a hole, defined by formulas, with its shadow."""

from guide_image import GuideImage
from interlume import (
    vtkConstructiveVolume, vtkShadowedSliceMapper, vtkSpatialOperation, vtkSpatialPrimitive)
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkLight, vtkVolume

picture = GuideImage()

ball = vtkSpatialPrimitive()
ball.SetShapeToSphere()
ball.SetRadius(0.9)
hole = vtkSpatialPrimitive()
hole.SetShapeToCylinder()
hole.SetRadius(0.4)
hole.SetHeight(3.0)
ring = vtkSpatialOperation()
ring.SetOperationToDifference()
ring.AddOperand(ball)
ring.AddOperand(hole)
image = vtkConstructiveVolume()
image.SetRoot(ring)
image.SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0)
image.SetDimensions(96, 96, 96)
image.SetNumberOfSubsamples(4)
mapper = vtkShadowedSliceMapper()
mapper.SetInputConnection(image.GetOutputPort())
color = vtkColorTransferFunction()
color.AddRGBPoint(0.0, 0.93, 0.69, 0.26)
opacities = vtkPiecewiseFunction()
opacities.AddPoint(0.0, 0.0)
opacities.AddPoint(1.0, 0.9)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(color)
volume.GetProperty().SetScalarOpacity(opacities)
volume.GetProperty().SetScalarOpacityUnitDistance(0.03)
volume.GetProperty().ShadeOn()
picture.renderer.AddVolume(volume)
sun = vtkLight()
sun.SetPosition(1.0, -0.4, 1.6)
sun.SetIntensity(1.8)
picture.renderer.AddLight(sun)

picture.write(0.6, -1.0, 1.2)
