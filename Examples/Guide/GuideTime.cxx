// SPDX-License-Identifier: BSD-3-Clause
// The region that an interval of a vortex field covers at any time between two time steps.

#include "GuideImage.h"

#include <vtkAnalyticFieldSource.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataObject.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTimeVaryingIntervalVolume.h>
#include <vtkTimeWeightedTetrahedraMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkAnalyticFieldSource> vortices;
  vortices->SetFieldToVortex();
  vortices->SetDimensions(48, 48, 48);
  vortices->SetTimeRange(1.2, 2.0);
  vortices->SetNumberOfTimeSteps(2);
  vtkNew<vtkTimeVaryingIntervalVolume> swept;
  swept->SetInputConnection(vortices->GetOutputPort());
  swept->SetInterval(0, 0.5, 2.0);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputConnection(swept->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("Time");
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(1.2, 0.22, 0.44, 0.72);
  colors->AddRGBPoint(2.0, 0.79, 0.29, 0.23);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(1.2, 60.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);
  renderer->AddVolume(volume);

  return image.Write(0.3, -1.0, 0.25);
}
