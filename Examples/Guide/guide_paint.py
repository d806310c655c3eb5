# SPDX-License-Identifier: BSD-3-Clause
"""A checkered image on the inflow, advected through the volume. A new image needs no new advection."""

from guide_image import GuideImage
from interlume import (
    vtkAnalyticFlowSource, vtkImplicitFlowField, vtkImplicitFlowVolumeMapper, vtkTerminationPlane)
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkRenderingCore import vtkVolume

picture = GuideImage()

flow = vtkAnalyticFlowSource()
flow.SetField(vtkAnalyticFlowSource.SADDLE)
flow.SetBounds(-1.0, 1.0, -1.0, 1.0, 0.0, 1.0)
inflow = vtkTerminationPlane()
inflow.SetOrigin(-0.6, -0.6, 1.0)
inflow.SetPoint1(0.6, -0.6, 1.0)
inflow.SetPoint2(-0.6, 0.6, 1.0)
field = vtkImplicitFlowField()
field.SetInputConnection(flow.GetOutputPort())
field.AddTerminationSurface(inflow)
paint = vtkImageCanvasSource2D()
paint.SetScalarTypeToUnsignedChar()
paint.SetNumberOfScalarComponents(4)
paint.SetExtent(0, 63, 0, 63, 0, 0)
paint.SetDrawColor(0.0, 0.0, 0.0, 0.0)
paint.FillBox(0, 63, 0, 63)
paint.SetDrawColor(200.0, 74.0, 59.0, 200.0)
paint.FillBox(8, 28, 8, 55)
paint.SetDrawColor(56.0, 112.0, 184.0, 200.0)
paint.FillBox(36, 56, 8, 55)
paint.Update()
mapper = vtkImplicitFlowVolumeMapper()
mapper.SetInputConnection(field.GetOutputPort())
mapper.SetInflowTexture(inflow.GetId(), paint.GetOutput())
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetScalarOpacityUnitDistance(0.3)
picture.renderer.AddVolume(volume)

picture.write(1.0, -1.5, 0.5)
