# SPDX-License-Identifier: BSD-3-Clause
"""The region that an interval of a vortex field covers at any time between two time steps."""

from guide_image import GuideImage
from interlume import vtkAnalyticFieldSource, vtkTimeVaryingIntervalVolume, vtkTimeWeightedTetrahedraMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume

picture = GuideImage()

vortices = vtkAnalyticFieldSource()
vortices.SetFieldToVortex()
vortices.SetDimensions(48, 48, 48)
vortices.SetTimeRange(1.2, 2.0)
vortices.SetNumberOfTimeSteps(2)
swept = vtkTimeVaryingIntervalVolume()
swept.SetInputConnection(vortices.GetOutputPort())
swept.SetInterval(0, 0.5, 2.0)
mapper = vtkTimeWeightedTetrahedraMapper()
mapper.SetInputConnection(swept.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray("Time")
colors = vtkColorTransferFunction()
colors.AddRGBPoint(1.2, 0.22, 0.44, 0.72)
colors.AddRGBPoint(2.0, 0.79, 0.29, 0.23)
extinction = vtkPiecewiseFunction()
extinction.AddPoint(1.2, 60.0)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(extinction)
picture.renderer.AddVolume(volume)

picture.write(0.3, -1.0, 0.25)
