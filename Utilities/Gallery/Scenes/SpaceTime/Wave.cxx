// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/SpaceTime/Wave.h"

#include "vtkAnalyticFieldSource.h"

namespace gallery
{
vtkSmartPointer<vtkAnalyticFieldSource> MakeWave()
{
  auto wave = vtkSmartPointer<vtkAnalyticFieldSource>::New();
  wave->SetFieldToWave();
  wave->SetDimensions(40, 20, 20);
  wave->SetBounds(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0);
  wave->SetTimeRange(0.0, 1.0);
  wave->SetNumberOfTimeSteps(2);
  return wave;
}
}
